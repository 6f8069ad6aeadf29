// SPDX-License-Identifier: BSD-3-Clause
// What is looked at while a robot lies that is about to rise.
#include <boost/test/unit_test.hpp>

#include "quadruped.hpp"
#include "supervisor/leg_lift.hpp"
#include "supervisor/leg_pressing.hpp"
#include "supervisor/leg_weighing.hpp"
#include "supervisor/rise_plan.hpp"

using namespace surefoot;

namespace {

constexpr double kTick = 0.002;  // [s]
using Verdict = LegWeighing::Verdict;

/// What bears the legs of a lying robot: hips by their side of the body, thighs a little.
Vector12 bearing(double hip = 0.7, double thigh = 0.3) {
  Vector12 tau;
  tau << -hip, thigh, 0.0, hip, thigh, 0.0, -hip, thigh, 0.0, hip, thigh, 0.0;
  return tau;
}

struct Folded {
  RisePlan plan = plan_rise(quadruped(), 50.0);
  LegWeighing weighing{plan};
  LegPressing pressing{plan};

  Verdict weigh(const Vector12& measured,
                const std::array<bool, kLegs>& legs = {true, true, true, true}) {
    weighing.start(plan.folded, legs);
    for (double time = 0.0; time < 3.0 && weighing.verdict() == Verdict::kNone; time += kTick) {
      const JointReference& now = weighing.step(measured, bearing(), kTick);
      BOOST_REQUIRE(now.dq.cwiseAbs().maxCoeff() < 1.0);
      last = now;
    }
    return weighing.verdict();
  }
  /// A body that turns about an axis as the rear feet are pressed down. @return [rad] most
  template <typename Turn>
  double press(Turn&& turn, double borne = 0.3) {
    pressing.start(plan.folded);
    double most = 0.0;
    last = {plan.folded, Vector12::Zero()};
    for (double time = 0.0; time < 6.0 && !pressing.passed() && !pressing.failed(); time += kTick) {
      const double pressed = (last.q - plan.folded).cwiseAbs().maxCoeff();
      const Vector3 by = turn(std::max(pressed - 0.1, 0.0));
      most = std::max(most, by.norm());
      const double angle = std::max(by.norm(), 1e-9);
      const JointReference before = last;
      last = pressing.step(Quaternion(Eigen::AngleAxisd(angle, by / angle)), borne, kTick);
      BOOST_REQUIRE((last.dq - before.dq).cwiseAbs().maxCoeff() < 0.1);
      BOOST_REQUIRE((last.q - plan.folded).head<6>().isZero());
    }
    return most;
  }
  JointReference last;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(rise_checks)

BOOST_FIXTURE_TEST_CASE(legs_that_weigh_what_they_should_fit_and_are_put_back, Folded) {
  BOOST_TEST((weigh(bearing()) == Verdict::kFits));
  BOOST_TEST((last.q - plan.folded).norm() < 1e-9);
  BOOST_TEST((weigh(bearing(0.5)) == Verdict::kFits));  // friction
  Vector12 leaning = bearing();
  leaning[0] *= 1.8;
  BOOST_TEST((weigh(leaning) == Verdict::kFits));
}

BOOST_FIXTURE_TEST_CASE(legs_on_the_wrong_side_are_named_and_so_is_another_robot, Folded) {
  Vector12 turned = bearing();
  turned[3] = -turned[3];
  BOOST_TEST((weigh(turned) == Verdict::kWrongSide));
  BOOST_TEST(weighing.motor() == 3);
  Vector12 swapped = bearing();
  std::swap(swapped[0], swapped[3]);
  BOOST_TEST((weigh(swapped) == Verdict::kWrongSide));
  BOOST_TEST(weighing.motor() == 0);
  Vector12 down = bearing();  // it lies on the ground
  down[3] *= 5.0;
  BOOST_TEST((weigh(down) == Verdict::kWrongSide));
  BOOST_TEST(weighing.motor() == 3);
  Vector12 inward = bearing();  // the front legs
  inward[0] = inward[3] *= 2.2;
  inward[0] *= -1.0;
  BOOST_TEST((weigh(inward) == Verdict::kWrongSide));
  BOOST_TEST(weighing.motor() < 6);
  BOOST_TEST((weigh(bearing(0.4)) == Verdict::kWrongWeight));
  BOOST_TEST((weigh(bearing(0.2)) == Verdict::kWrongWeight));
  BOOST_TEST((weigh(bearing(4.0)) == Verdict::kWrongWeight));
  BOOST_TEST((weigh(Vector12::Constant(NAN)) != Verdict::kFits));
}

BOOST_FIXTURE_TEST_CASE(the_folded_legs_of_one_side_tell_while_the_others_are_left_alone, Folded) {
  const std::array<bool, kLegs> left = {false, true, false, true};
  Vector12 wedged = bearing();  // the right legs hold each other
  wedged[0] = 9.0, wedged[6] = -9.0;
  BOOST_TEST((weigh(wedged, left) == Verdict::kFits));
  BOOST_TEST((weigh(wedged) != Verdict::kFits));
  BOOST_TEST((weigh(bearing(4.0), left) == Verdict::kWrongWeight));
  Vector12 leant_on = bearing();  // the body takes of what they weigh, or turns it round
  leant_on[3] *= 0.15, leant_on[9] *= -3.0;
  BOOST_TEST((weigh(leant_on, left) == Verdict::kFits));
  leant_on[9] *= -0.05;  // both alike
  BOOST_TEST((weigh(leant_on, left) == Verdict::kFits));
  leant_on[9] = 4.0 * bearing()[9];  // and makes nothing so heavy
  BOOST_TEST((weigh(leant_on, left) == Verdict::kWrongSide));
  BOOST_TEST(weighing.motor() == 9);
  weighing.start(plan.folded, left);
  double moved = 0.0;
  for (double time = 0.0; time < 0.6; time += kTick) {
    const Vector12 off = weighing.step(bearing(), bearing(), kTick).q - plan.folded;
    BOOST_REQUIRE(off[0] == 0.0);
    BOOST_REQUIRE(off[6] == 0.0);
    moved = off[3];
  }
  BOOST_TEST(moved > 0.1);
}

BOOST_FIXTURE_TEST_CASE(rear_legs_that_press_put_the_nose_down, Folded) {
  press([](double x) { return Vector3(0.05 * x, x, -x); });
  BOOST_TEST(pressing.passed());
  BOOST_TEST((last.q - plan.folded).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(legs_that_do_anything_else_to_the_body_fail_before_it_is_up, Folded) {
  for (const Vector3& way : {Vector3(0, -1, 0), Vector3(1, 0, 0), Vector3(0.1, 1, 0),
                             Vector3(0, 0, 1), Vector3(0, 0, 0)}) {
    const double most = press([&](double x) { return Vector3(x * way); });
    BOOST_TEST(!pressing.passed());
    BOOST_TEST(pressing.failed());
    BOOST_TEST((most < 0.15 || way.head<2>().isZero()));
    BOOST_TEST((last.q - plan.folded).norm() < 1e-9);
  }
}

BOOST_FIXTURE_TEST_CASE(a_body_that_rolls_over_its_nose_is_one_that_legs_bear_a_part_of, Folded) {
  const auto rolls = [](double x) { return Vector3(0.6 * x, x, 0.0); };
  press(rolls, 0.2);
  BOOST_TEST(pressing.passed());
  press(rolls, 0.25);
  BOOST_TEST(pressing.failed());
}

BOOST_FIXTURE_TEST_CASE(a_body_that_lay_unevenly_is_pressed_once_more, Folded) {
  double most = 0.0, before = 0.0;
  int presses = 0;
  press([&](double x) {
    presses += x > 0.0 && before == 0.0;
    before = x;
    most = std::max(most, x);
    return presses == 1 ? Vector3(x, 0.5 * x, 0.0) : Vector3(0.0, x, 0.0);
  });
  BOOST_TEST(presses == 2);
  BOOST_TEST(pressing.passed());
}

BOOST_FIXTURE_TEST_CASE(legs_that_find_nothing_to_press_on_say_nothing, Folded) {
  press([](double) { return Vector3(0.0, 0.0, 0.0); }, 0.02);
  BOOST_TEST(pressing.passed());
  press([](double x) { return Vector3(0.0, -x, 0.0); }, 0.02);
  BOOST_TEST(pressing.failed());
}

BOOST_AUTO_TEST_CASE(legs_far_too_light_come_up_against_their_springs) {
  const auto light = [](const Vector12& measured) {
    LegLift lift;
    for (double time = 0.0; time < 1.0 && !lift.done(); time += kTick) {
      lift.update(measured, bearing(5.0, 3.0), kTick);
    }
    BOOST_TEST(lift.done());
    return lift.too_light();
  };
  BOOST_TEST(light(bearing(0.7, 0.3)));
  BOOST_TEST(!light(bearing(5.0, 3.0)));
  BOOST_TEST(!light(bearing(5.0, 0.3)));    // thighs that the ground holds up
  BOOST_TEST(!light(bearing(-9.0, -9.0)));  // the body lies on its legs
  Vector12 some = bearing(0.7, 0.3);        // two legs: the others rest on something
  some.head<6>() = bearing(5.0, 3.0).head<6>();
  BOOST_TEST(light(some));
  some[9] = 5.0;  // one leg and a half
  BOOST_TEST(!light(some));
  BOOST_TEST(!light(0.5 * bearing(5.0, -3.0)));  // hips alone: thighs are pushed
  Vector12 apart = bearing(5.0, 3.0);
  for (int i = 0; i < kMotors; ++i) apart[i] *= 0.55 - 0.04 * i;
  BOOST_TEST(!light(apart));
}

BOOST_AUTO_TEST_SUITE_END()
