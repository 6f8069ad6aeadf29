// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "robot_states.hpp"
#include "supervisor/getting_up/joint_impedance.hpp"

using namespace surefoot;

namespace {

constexpr double kWatts = 80.0;

// A leg that comes free from under the body runs away: nothing holds its thigh.
struct RunawayLeg {
  Robot robot = quadruped();
  RisePlan plan = plan_rise(robot, kWatts);
  JointImpedance impedance{robot, plan, kWatts};

  // Return the power of the motors [W], including their own damping.
  double power(double thigh) {
    LowState report = resting_sample(robot, 0);
    report.motorState[FL_1].dq = static_cast<float>(thigh);
    impedance.read(report);
    JointReference reference;
    reference.q = impedance.q();
    const Vector12 tau = impedance.torques(reference, 0.2);
    const double dq = report.motorState[FL_1].dq;
    return std::abs((tau[FL_1] - impedance.damping() * dq) * dq);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(joint_impedance)

// Damping alone would take 2 and 10 times the power limit.
BOOST_FIXTURE_TEST_CASE(braking_a_runaway_leg_stays_within_the_power_limit, RunawayLeg) {
  for (const double factor : {2.0, 10.0}) {
    const double thigh = std::sqrt(factor * kWatts / plan.damping);
    BOOST_TEST(power(thigh) < kWatts * (1.0 + 1e-6));
    BOOST_TEST(power(-thigh) < kWatts * (1.0 + 1e-6));
    BOOST_TEST(power(thigh) > 0.9 * kWatts);  // it brakes with the power that is available
  }
}

// Torques that hold a whole robot are far beyond the torque share of hot motors.
BOOST_FIXTURE_TEST_CASE(power_limiting_keeps_the_motor_torque_share, RunawayLeg) {
  const double share = 0.05;
  impedance.set_torque_share(Vector12::Constant(share));
  for (const double way : {-1.0, 1.0}) {
    LowState report = resting_sample(robot, 0);
    report.motorState[FL_1].dq = static_cast<float>(way * std::sqrt(0.98 * kWatts / plan.damping));
    impedance.read(report);
    JointReference reference;
    // The springs pull against the motion of FL_1.
    reference.q = impedance.q() - Vector12::Constant(0.4 * way);
    const Vector12 tau = impedance.torques(reference, 1.0);
    for (int i = 0; i < kMotors; ++i) {
      BOOST_TEST(std::abs(tau[i]) <= share * robot.config().tau_max[i]);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(damping_is_unchanged_within_the_power_limit, RunawayLeg) {
  const double thigh = std::sqrt(0.5 * kWatts / plan.damping);
  BOOST_TEST(std::abs(power(thigh) - power(-thigh)) < kWatts);
  BOOST_TEST(power(thigh) > 0.2 * kWatts);
  BOOST_TEST(impedance.damping() == plan.damping);
}

BOOST_FIXTURE_TEST_CASE(damping_decreases_while_the_body_rotates, RunawayLeg) {
  const auto after = [&](double turning) {
    for (int tick = 0; tick < 100; ++tick) impedance.reduce_damping(turning, 0.002);
    return impedance.damping() / plan.damping;
  };
  BOOST_TEST(after(0.5) == 1.0);
  impedance.reduce_damping(3.0, 0.002);
  BOOST_TEST(impedance.damping() > 0.9 * plan.damping);  // gradually: no step of torque
  BOOST_TEST(std::abs(after(3.0) - 0.25) < 0.01);
  BOOST_TEST(std::abs(after(1.1) - 0.625) < 0.01);
  BOOST_TEST(std::abs(after(0.0) - 1.0) < 0.01);
}

// A leg that has caught under the body comes free faster than its torques can change.
BOOST_FIXTURE_TEST_CASE(released_springs_stay_within_the_power_limit, RunawayLeg) {
  for (const double turning : {0.0, 3.0}) {
    for (int tick = 0; tick < 100; ++tick) impedance.reduce_damping(turning, 0.002);
    impedance.read(resting_sample(robot, 0));
    JointReference reference;
    reference.q = impedance.q();
    const Vector12 hold = impedance.torques(reference, 0.0);
    for (int i : {RR_0, RR_1, RR_2, FL_1}) reference.q[i] += 0.4;
    const Vector12 pull = impedance.torques(reference, 0.0) - hold;
    // Each spring at the speed at which it takes most power, braked only by its motor.
    const double released = pull.squaredNorm() / (4.0 * impedance.damping());
    BOOST_TEST(released < 1.01 * kWatts);
    BOOST_TEST(released > 0.6 * kWatts);  // it pulls with the power that is available
    BOOST_TEST(std::abs(pull[RR_0] - pull[FL_1]) < 1e-9);
  }
}

// Loaded legs have not caught, and they need the full spring torque.
BOOST_FIXTURE_TEST_CASE(loaded_legs_apply_the_full_spring_torque, RunawayLeg) {
  impedance.read(resting_sample(robot, 0));
  JointReference reference;
  reference.q = impedance.q();
  const Vector12 hold = impedance.torques(reference, 0.5);
  reference.q -= Vector12::Constant(0.1);
  const Vector12 pull = impedance.torques(reference, 0.5) - hold;
  BOOST_TEST(std::abs(pull[FL_1] + 0.1 * plan.stiffness) < 1e-9);
}

// The spring torque grows without a step while the legs take the weight of the body.
BOOST_FIXTURE_TEST_CASE(spring_torque_increases_smoothly_with_leg_load, RunawayLeg) {
  impedance.read(resting_sample(robot, 0));
  JointReference still, taut;
  still.q = taut.q = impedance.q();
  for (int i : {RR_0, RR_1, RR_2, FL_1}) taut.q[i] += 0.4;
  double before = 0.0, least = 1.0, most = 0.0;
  for (int k = 0; k <= 100; ++k) {
    const double load = 0.0015 * k;
    const double pull = (impedance.torques(taut, load) - impedance.torques(still, load)).norm();
    if (k > 0) least = std::min(least, pull - before), most = std::max(most, pull - before);
    before = pull;
  }
  BOOST_TEST(least > -0.02);
  BOOST_TEST(most < 0.3);  // [N.m] per step of load; 12 in total
}

BOOST_AUTO_TEST_SUITE_END()
