// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "scenes.hpp"
#include "supervisor/leg_springs.hpp"

using namespace surefoot;

namespace {

constexpr double kWatts = 80.0;

// A leg that has come free from under the body is flung: nothing holds its thigh.
struct Flung {
  Robot robot = quadruped();
  RisePlan plan = plan_rise(robot, kWatts);
  LegSprings springs{robot, plan, kWatts};

  // What the motors take [W], their own damping included.
  double power(double thigh) {
    LowState report = resting_report(robot, 0);
    report.motorState[FL_1].dq = static_cast<float>(thigh);
    springs.read(report);
    JointReference reference;
    reference.q = springs.q();
    const Vector12 tau = springs.torques(reference, 0.2);
    const double dq = report.motorState[FL_1].dq;
    return std::abs((tau[FL_1] - springs.damping() * dq) * dq);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(leg_springs)

// By their damping alone the motors would take two, and ten, times the power.
BOOST_FIXTURE_TEST_CASE(braking_a_flung_leg_stays_within_the_power, Flung) {
  for (const double factor : {2.0, 10.0}) {
    const double thigh = std::sqrt(factor * kWatts / plan.damping);
    BOOST_TEST(power(thigh) < kWatts * (1.0 + 1e-6));
    BOOST_TEST(power(-thigh) < kWatts * (1.0 + 1e-6));
    BOOST_TEST(power(thigh) > 0.9 * kWatts);  // it does brake with what there is
  }
}

BOOST_FIXTURE_TEST_CASE(within_the_power_the_damping_is_whole, Flung) {
  const double thigh = std::sqrt(0.5 * kWatts / plan.damping);
  BOOST_TEST(std::abs(power(thigh) - power(-thigh)) < kWatts);
  BOOST_TEST(power(thigh) > 0.2 * kWatts);
  BOOST_TEST(springs.damping() == plan.damping);
}

BOOST_AUTO_TEST_SUITE_END()
