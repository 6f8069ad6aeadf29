// SPDX-License-Identifier: BSD-3-Clause
// Checks of a lying robot before it rises.
#include <boost/test/unit_test.hpp>

#include "quadruped.hpp"
#include "supervisor/getting_up/checks/leg_weight_check.hpp"
#include "supervisor/getting_up/checks/light_leg_check.hpp"
#include "supervisor/getting_up/checks/rear_press_check.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

using namespace surefoot;

namespace {

constexpr double kTick = 0.002;  // [s]
using Verdict = LegWeightCheck::Verdict;

/// Return the torques that hold the legs of a lying robot: hips by side of the body, thighs a
/// little.
Vector12 leg_torques(double hip = 0.7, double thigh = 0.3) {
  Vector12 tau;
  tau << -hip, thigh, 0.0, hip, thigh, 0.0, -hip, thigh, 0.0, hip, thigh, 0.0;
  return tau;
}

struct FoldedLegs {
  RisePlan plan = plan_rise(quadruped(), 50.0);
  LegWeightCheck weight_check{plan};
  RearPressCheck press_check{plan};

  Verdict weigh(const Vector12& measured,
                const std::array<bool, kLegs>& legs = {true, true, true, true}) {
    weight_check.start(plan.folded, legs);
    for (double time = 0.0; time < 3.0 && weight_check.verdict() == Verdict::kNone; time += kTick) {
      const JointReference& now = weight_check.step(measured, leg_torques(), kTick);
      BOOST_REQUIRE(now.dq.cwiseAbs().maxCoeff() < 1.0);
      last = now;
    }
    return weight_check.verdict();
  }
  /// Run the press check with a body that turns as the rear feet press. @return largest turn [rad]
  template <typename Turn>
  double press(Turn&& turn, double borne = 0.3) {
    press_check.start(plan.folded);
    double most = 0.0;
    last = {plan.folded, Vector12::Zero()};
    for (double time = 0.0; time < 6.0 && !press_check.passed() && !press_check.failed();
         time += kTick) {
      const double pressed = (last.q - plan.folded).cwiseAbs().maxCoeff();
      const Vector3 by = turn(std::max(pressed - 0.1, 0.0));
      most = std::max(most, by.norm());
      const double angle = std::max(by.norm(), 1e-9);
      const JointReference before = last;
      last = press_check.step(Quaternion(Eigen::AngleAxisd(angle, by / angle)), borne, kTick);
      BOOST_REQUIRE((last.dq - before.dq).cwiseAbs().maxCoeff() < 0.1);
      BOOST_REQUIRE((last.q - plan.folded).head<6>().isZero());
    }
    return most;
  }
  JointReference last;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(rise_checks)

BOOST_FIXTURE_TEST_CASE(legs_with_expected_weight_pass_and_return_to_fold, FoldedLegs) {
  BOOST_TEST((weigh(leg_torques()) == Verdict::kFits));
  BOOST_TEST((last.q - plan.folded).norm() < 1e-9);
  BOOST_TEST((weigh(leg_torques(0.5)) == Verdict::kFits));  // friction
  Vector12 leaning = leg_torques();
  leaning[0] *= 1.8;
  BOOST_TEST((weigh(leaning) == Verdict::kFits));
}

BOOST_FIXTURE_TEST_CASE(wrong_side_motor_is_named_and_wrong_weight_is_reported, FoldedLegs) {
  Vector12 turned = leg_torques();
  turned[3] = -turned[3];
  BOOST_TEST((weigh(turned) == Verdict::kWrongSide));
  BOOST_TEST(weight_check.motor() == 3);
  Vector12 swapped = leg_torques();
  std::swap(swapped[0], swapped[3]);
  BOOST_TEST((weigh(swapped) == Verdict::kWrongSide));
  BOOST_TEST(weight_check.motor() == 0);
  Vector12 down = leg_torques();  // the leg lies on the ground
  down[3] *= 5.0;
  BOOST_TEST((weigh(down) == Verdict::kWrongSide));
  BOOST_TEST(weight_check.motor() == 3);
  Vector12 inward = leg_torques();  // both front legs
  inward[0] = inward[3] *= 2.2;
  inward[0] *= -1.0;
  BOOST_TEST((weigh(inward) == Verdict::kWrongSide));
  BOOST_TEST(weight_check.motor() < 6);
  BOOST_TEST((weigh(leg_torques(0.4)) == Verdict::kWrongWeight));
  BOOST_TEST((weigh(leg_torques(0.2)) == Verdict::kWrongWeight));
  BOOST_TEST((weigh(leg_torques(4.0)) == Verdict::kWrongWeight));
  BOOST_TEST((weigh(Vector12::Constant(NAN)) != Verdict::kFits));
}

BOOST_FIXTURE_TEST_CASE(one_folded_side_is_weighed_while_the_other_does_not_move, FoldedLegs) {
  const std::array<bool, kLegs> left = {false, true, false, true};
  Vector12 interfering = leg_torques();  // the right legs block each other
  interfering[0] = 9.0, interfering[6] = -9.0;
  BOOST_TEST((weigh(interfering, left) == Verdict::kFits));
  BOOST_TEST((weigh(interfering) != Verdict::kFits));
  BOOST_TEST((weigh(leg_torques(4.0), left) == Verdict::kWrongWeight));
  // The body carries part of their weight, or reverses their torque.
  Vector12 leant_on = leg_torques();
  leant_on[3] *= 0.15, leant_on[9] *= -3.0;
  BOOST_TEST((weigh(leant_on, left) == Verdict::kFits));
  leant_on[9] *= -0.05;  // both ratios alike
  BOOST_TEST((weigh(leant_on, left) == Verdict::kFits));
  leant_on[9] = 4.0 * leg_torques()[9];  // the body cannot make a leg that heavy
  BOOST_TEST((weigh(leant_on, left) == Verdict::kWrongSide));
  BOOST_TEST(weight_check.motor() == 9);
  weight_check.start(plan.folded, left);
  double moved = 0.0;
  for (double time = 0.0; time < 0.6; time += kTick) {
    const Vector12 off = weight_check.step(leg_torques(), leg_torques(), kTick).q - plan.folded;
    BOOST_REQUIRE(off[0] == 0.0);
    BOOST_REQUIRE(off[6] == 0.0);
    moved = off[3];
  }
  BOOST_TEST(moved > 0.1);
}

BOOST_FIXTURE_TEST_CASE(pressing_rear_legs_pitch_the_body_down, FoldedLegs) {
  press([](double x) { return Vector3(0.05 * x, x, -x); });
  BOOST_TEST(press_check.passed());
  BOOST_TEST((last.q - plan.folded).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(other_body_motion_fails_the_pressing_check, FoldedLegs) {
  for (const Vector3& way : {Vector3(0, -1, 0), Vector3(1, 0, 0), Vector3(0.1, 1, 0),
                             Vector3(0, 0, 1), Vector3(0, 0, 0)}) {
    const double most = press([&](double x) { return Vector3(x * way); });
    BOOST_TEST(!press_check.passed());
    BOOST_TEST(press_check.failed());
    BOOST_TEST((most < 0.15 || way.head<2>().isZero()));
    BOOST_TEST((last.q - plan.folded).norm() < 1e-9);
  }
}

BOOST_FIXTURE_TEST_CASE(combined_roll_and_pitch_passes_only_at_low_leg_load, FoldedLegs) {
  const auto rolls = [](double x) { return Vector3(0.6 * x, x, 0.0); };
  press(rolls, 0.2);
  BOOST_TEST(press_check.passed());
  press(rolls, 0.25);
  BOOST_TEST(press_check.failed());
}

BOOST_FIXTURE_TEST_CASE(unevenly_lying_body_is_pressed_a_second_time, FoldedLegs) {
  double most = 0.0, before = 0.0;
  int presses = 0;
  press([&](double x) {
    presses += x > 0.0 && before == 0.0;
    before = x;
    most = std::max(most, x);
    return presses == 1 ? Vector3(x, 0.5 * x, 0.0) : Vector3(0.0, x, 0.0);
  });
  BOOST_TEST(presses == 2);
  BOOST_TEST(press_check.passed());
}

BOOST_FIXTURE_TEST_CASE(unloaded_legs_pass_unless_the_body_pitches_up, FoldedLegs) {
  press([](double) { return Vector3(0.0, 0.0, 0.0); }, 0.02);
  BOOST_TEST(press_check.passed());
  press([](double x) { return Vector3(0.0, -x, 0.0); }, 0.02);
  BOOST_TEST(press_check.failed());
}

BOOST_AUTO_TEST_CASE(legs_far_lighter_than_expected_are_detected) {
  const auto light = [](const Vector12& measured) {
    LightLegCheck lift;
    for (double time = 0.0; time < 1.0 && !lift.done(); time += kTick) {
      lift.update(measured, leg_torques(5.0, 3.0), kTick);
    }
    BOOST_TEST(lift.done());
    return lift.too_light();
  };
  BOOST_TEST(light(leg_torques(0.7, 0.3)));
  BOOST_TEST(!light(leg_torques(5.0, 3.0)));
  BOOST_TEST(!light(leg_torques(5.0, 0.3)));    // the ground holds the thighs up
  BOOST_TEST(!light(leg_torques(-9.0, -9.0)));  // the body lies on its legs
  Vector12 some = leg_torques(0.7, 0.3);        // two legs hang free, the others rest on something
  some.head<6>() = leg_torques(5.0, 3.0).head<6>();
  BOOST_TEST(light(some));
  some[9] = 5.0;  // one leg and a half
  BOOST_TEST(!light(some));
  BOOST_TEST(!light(0.5 * leg_torques(5.0, -3.0)));  // only the hips agree: the thighs are pushed
  Vector12 apart = leg_torques(5.0, 3.0);
  for (int i = 0; i < kMotors; ++i) apart[i] *= 0.55 - 0.04 * i;
  BOOST_TEST(!light(apart));
}

BOOST_AUTO_TEST_SUITE_END()
