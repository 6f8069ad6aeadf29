// SPDX-License-Identifier: BSD-3-Clause
// Legs near a singularity: a straight knee, a foot at the height of its hip.
#include <boost/test/unit_test.hpp>

#include "surefoot/whole_body_controller.hpp"
#include "wide_range_quadruped.hpp"

using namespace surefoot;

namespace {

// Largest torque steps on a path, without and with a change of the form, and the largest torque.
struct TorqueSteps {
  double smooth = 0.0, switching = 0.0, torque = 0.0;
  int switches = 0;
};

template <typename Pose>
TorqueSteps follow(WideRangeRobot& s, const Reference& stance_template, Pose&& pose) {
  WholeBodyController controller(s.robot);
  TorqueSteps steps;
  Solution last;
  constexpr int kPoses = 4000;
  for (int k = 0; k <= kPoses; ++k) {
    pose(static_cast<double>(k) / kPoses);
    Reference reference = reference_at(s.robot, s.state);
    reference.feet[FL_].stance = stance_template.feet[FL_].stance;
    const Solution& now = controller.update(s.state, reference);
    BOOST_REQUIRE(is_usable(now.status));
    BOOST_REQUIRE(s.within_torque_limits(now));
    if (k > 0) {
      const double step = (now.torques - last.torques).cwiseAbs().maxCoeff();
      double& worst = now.form == last.form ? steps.smooth : steps.switching;
      worst = std::max(worst, step);
      steps.switches += now.form != last.form;
    }
    steps.torque = std::max(steps.torque, now.torques.cwiseAbs().maxCoeff());
    last = now;
  }
  return steps;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(singular_legs)

BOOST_FIXTURE_TEST_CASE(straight_knee_is_solved_only_in_the_general_form, WideRangeRobot) {
  set(FL_2, 0.0);
  const Reference at = reference_at(robot, state);
  WholeBodyController condensed(robot, Gains(), {QpForm::kCondensed});
  BOOST_TEST((condensed.update(state, at).status == Status::kSingular));
  for (const QpForm form : {QpForm::kAuto, QpForm::kGeneral}) {
    WholeBodyController controller(robot, Gains(), {form});
    const Solution& s = controller.update(state, at);
    BOOST_TEST(is_usable(s.status));
    BOOST_TEST((s.form == QpForm::kGeneral));
    BOOST_TEST(within_torque_limits(s));
  }
}

BOOST_FIXTURE_TEST_CASE(foot_at_hip_height_is_solved_within_torque_limits, WideRangeRobot) {
  for (const double thigh : {2.3, 2.36, 2.3708, 2.38, 2.5, 2.8}) {
    for (const bool moving : {false, true}) {
      set(FL_1, thigh);
      state.v.setConstant(moving ? 0.5 : 0.0);
      WholeBodyController controller(robot);
      const Solution& s = controller.update(state, reference_at(robot, state));
      BOOST_TEST(is_usable(s.status));
      BOOST_TEST((s.form == QpForm::kGeneral));
      BOOST_TEST(within_torque_limits(s));
      BOOST_TEST(std::abs(s.forces.row(2).sum() - robot.mass() * kGravity) < 40.0);
    }
  }
}

// 4000 poses through a knee that bends to the other side, and through a foot that rises above its
// hip. The torques do not jump, not even where the form changes.
BOOST_FIXTURE_TEST_CASE(torques_stay_bounded_and_continuous_through_a_singularity, WideRangeRobot) {
  for (const bool stance : {true, false}) {
    Reference stance_template;
    stance_template.feet[FL_].stance = stance;
    const TorqueSteps knee = follow(*this, stance_template, [&](double u) {
      set(FL_2, -1.6 + 2.6 * u);
      set(FL_1, 0.8 - 1.3 * u);
    });
    set(FL_2, -1.6);
    const TorqueSteps foot =
        follow(*this, stance_template, [&](double u) { set(FL_1, 0.8 + 1.9 * u); });
    set(FL_1, 0.8);
    BOOST_TEST(knee.switches == 2);
    for (const TorqueSteps& steps : {knee, foot}) {
      BOOST_TEST_MESSAGE("steps " << steps.smooth << ", where the form changes " << steps.switching
                                  << " N.m");
      BOOST_TEST(steps.smooth < 0.1);
      BOOST_TEST(steps.switching < 0.02);
      BOOST_TEST(steps.torque < 15.0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
