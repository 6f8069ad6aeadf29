// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

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

BOOST_FIXTURE_TEST_CASE(it_damps_in_full_once_that_is_within_the_power, Flung) {
  BOOST_TEST(springs.damping() == plan.damping);
  power(std::sqrt(4.0 * kWatts / plan.damping));
  BOOST_TEST(springs.damping() < 0.5 * plan.damping);
  power(std::sqrt(0.5 * kWatts / plan.damping));
  BOOST_TEST(springs.damping() == plan.damping);
}

BOOST_FIXTURE_TEST_CASE(a_speed_that_is_none_takes_no_damping_away, Flung) {
  power(std::numeric_limits<double>::quiet_NaN());
  BOOST_TEST(springs.damping() == plan.damping);
}

BOOST_AUTO_TEST_SUITE_END()
