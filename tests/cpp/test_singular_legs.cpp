// SPDX-License-Identifier: BSD-3-Clause
// Legs near singular: a straight knee, a foot at the height of its hip.
#include <boost/test/unit_test.hpp>

#include "supple.hpp"
#include "surefoot/whole_body_controller.hpp"

using namespace surefoot;

namespace {

// Greatest step of a torque along a path, and greatest of all, apart where the form changes.
struct Steps {
  double smooth = 0.0, switching = 0.0, torque = 0.0;
  int switches = 0;
};

template <typename Pose>
Steps follow(Supple& s, const Reference& like, Pose&& pose) {
  WholeBodyController controller(s.robot);
  Steps steps;
  Solution last;
  constexpr int kPoses = 4000;
  for (int k = 0; k <= kPoses; ++k) {
    pose(static_cast<double>(k) / kPoses);
    Reference reference = reference_at(s.robot, s.state);
    reference.feet[FL_].stance = like.feet[FL_].stance;
    const Solution& now = controller.update(s.state, reference);
    BOOST_REQUIRE(is_usable(now.status));
    BOOST_REQUIRE(s.inside_motors(now));
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

BOOST_FIXTURE_TEST_CASE(a_straight_knee_is_refused_condensed_and_solved_otherwise, Supple) {
  set(FL_2, 0.0);
  const Reference at = reference_at(robot, state);
  WholeBodyController condensed(robot, Gains(), {Form::kCondensed});
  BOOST_TEST((condensed.update(state, at).status == Status::kSingular));
  for (const Form form : {Form::kAuto, Form::kGeneral}) {
    WholeBodyController controller(robot, Gains(), {form});
    const Solution& s = controller.update(state, at);
    BOOST_TEST(is_usable(s.status));
    BOOST_TEST((s.form == Form::kGeneral));
    BOOST_TEST(inside_motors(s));
  }
}

BOOST_FIXTURE_TEST_CASE(a_foot_at_hip_height_is_solved_with_torques_inside_the_motors, Supple) {
  for (const double thigh : {2.3, 2.36, 2.3708, 2.38, 2.5, 2.8}) {
    for (const bool moving : {false, true}) {
      set(FL_1, thigh);
      state.v.setConstant(moving ? 0.5 : 0.0);
      WholeBodyController controller(robot);
      const Solution& s = controller.update(state, reference_at(robot, state));
      BOOST_TEST(is_usable(s.status));
      BOOST_TEST((s.form == Form::kGeneral));
      BOOST_TEST(inside_motors(s));
      BOOST_TEST(std::abs(s.forces.row(2).sum() - robot.mass() * kGravity) < 40.0);
    }
  }
}

// Four thousand poses through a knee that bends the other way, and a foot that rises past its hip.
// No torque steps, not even where the form changes.
BOOST_FIXTURE_TEST_CASE(a_leg_that_passes_a_singularity_has_bounded_torques_without_jumps, Supple) {
  for (const bool stance : {true, false}) {
    Reference like;
    like.feet[FL_].stance = stance;
    const Steps knee = follow(*this, like, [&](double u) {
      set(FL_2, -1.6 + 2.6 * u);
      set(FL_1, 0.8 - 1.3 * u);
    });
    set(FL_2, -1.6);
    const Steps foot = follow(*this, like, [&](double u) { set(FL_1, 0.8 + 1.9 * u); });
    set(FL_1, 0.8);
    BOOST_TEST(knee.switches == 2);
    for (const Steps& steps : {knee, foot}) {
      BOOST_TEST_MESSAGE("steps " << steps.smooth << ", where the form changes " << steps.switching
                                  << " N.m");
      BOOST_TEST(steps.smooth < 0.1);
      BOOST_TEST(steps.switching < 0.02);
      BOOST_TEST(steps.torque < 15.0);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
