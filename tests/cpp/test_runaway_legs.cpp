// SPDX-License-Identifier: BSD-3-Clause
// Runaway legs: legs that their own torques accelerate after their foot lost contact.
#include <boost/test/unit_test.hpp>
#include <random>

#include "pushed_robot.hpp"
#include "robot_states.hpp"
#include "safety/runaway_legs.hpp"
#include "safety/torque_command.hpp"
#include "surefoot/stand_controller.hpp"
#include "tick/controller_access.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(runaway_legs)

constexpr double kTick = 0.002;  // [s]

// Accelerate the thigh of FR by ddq [rad/s^2] from dq [rad/s] for 10 ticks. @return power rise of
// its leg [W]
double rise(double ddq, double tau, double dq = 0.0) {
  RunawayLegs legs;
  Vector12 speeds = Vector12::Constant(0.1), torques = Vector12::Constant(5.0);
  torques[1] = tau;
  for (int k = 0; k < 10; ++k) {
    speeds[1] = dq + k * kTick * ddq;
    legs.update(speeds, kTick);
  }
  BOOST_TEST(legs.power_rise(torques, 1) == 0.0);
  return legs.power_rise(torques, 0);
}

BOOST_AUTO_TEST_CASE(power_rise_counts_only_torques_that_drive_the_joint) {
  const auto percent = boost::test_tools::tolerance(0.01);
  BOOST_TEST(rise(0.0, 10.0) == 0.0);
  BOOST_TEST(rise(200.0, 10.0) == 10.0 * 200.0 * 0.015, percent);
  BOOST_TEST(rise(-200.0, -10.0) == 10.0 * 200.0 * 0.015, percent);
  BOOST_TEST(rise(200.0, -10.0) == 0.0);        // the torque brakes
  BOOST_TEST(rise(200.0, 10.0, -10.0) == 0.0);  // it still brakes after 15 ms
  // -2.4 rad/s now and 3.6 rad/s in 15 ms: the torque drives the joint from rest on.
  BOOST_TEST(rise(400.0, 10.0, -9.6) == 10.0 * 3.6, percent);
}

BOOST_AUTO_TEST_CASE(gaps_nan_and_speed_jumps_detect_no_runaway_leg) {
  const Vector12 torques = Vector12::Constant(10.0);
  RunawayLegs legs;
  const auto after = [&](double dq, double dt) {
    legs.update(Vector12::Constant(dq), dt);
    return legs.power_rise(torques, 2);
  };
  BOOST_TEST(after(3.0, kTick) == 0.0);  // first sample
  BOOST_TEST(after(3.5, kTick) > 10.0);
  BOOST_TEST(after(4.0, 0.010) == 0.0);  // a gap, which TickClock reports as 10 ms at most
  BOOST_TEST(after(4.5, kTick) > 10.0);
  BOOST_TEST(after(std::nan(""), kTick) == 0.0);
  BOOST_TEST(after(4.5, kTick) == 0.0);
  BOOST_TEST(after(5.0, kTick) > 10.0);
  BOOST_TEST(after(17.0, kTick) == 0.0);  // a wrong sample, then a right one
  BOOST_TEST(after(5.1, kTick) == 0.0);
  BOOST_TEST(after(5.6, kTick) > 10.0);
  legs.reset();
  BOOST_TEST(after(6.0, kTick) == 0.0);
}

// Noise of an encoder's velocity, 0.05 rad/s, at the torques of a stand stays below a leg's share
// of the lowest power limit, 90 W / 4.
BOOST_AUTO_TEST_CASE(encoder_noise_detects_no_runaway_leg) {
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 0.05);
  double most = 0.0;
  for (const double dt : {0.001, kTick}) {
    RunawayLegs legs;
    for (int k = 0; k < 100000; ++k) {
      Vector12 dq;
      for (double& speed : dq) speed = noise(generator);
      legs.update(dq, dt);
      most = std::max(most, legs.power_rise(Vector12::Constant(8.0), 0));
    }
  }
  BOOST_TEST(most < 0.9 * 90.0 / 4.0);
}

/// Two controllers, one of them with a power limit [W], on a robot whose front right calf
/// accelerates.
struct RunawayScene {
  explicit RunawayScene(double watts)
      : free(robot), limited(robot, robot.config().gains, options_with_limit(watts)) {
    for (StandController* c : {&free, &limited}) ControllerAccess::end_sensor_check(*c);
    for (int k = 0; k < 20; ++k) step(0.0);
    along = command.motorCmd[FR_2].tau > 0.0F ? 1.0F : -1.0F;
  }
  static ControllerOptions options_with_limit(double watts) {
    ControllerOptions options;
    options.power_limit = watts;
    return options;
  }
  void step(float dq) {
    report.tick += 2;
    report.motorState[FR_2].dq = along * dq;
    unlimited_command = free.update(report);
    command = limited.update(report);
    Vector12 speeds = Vector12::Zero(), torques;
    speeds[FR_2] = report.motorState[FR_2].dq;
    for (int i = 0; i < kMotors; ++i) torques[i] = unlimited_command.motorCmd[i].tau;
    legs.update(speeds, kTick);
    rise = legs.power_rise(torques, 0);
  }
  void accelerate_leg() {
    for (int k = 1; k <= 3; ++k) step(0.6F * static_cast<float>(k));
  }
  /// Return the share of its torque that the limit leaves the calf of a leg.
  double torque_ratio(int leg) const {
    const int calf = kLegJoints * leg + 2;
    return command.motorCmd[calf].tau / unlimited_command.motorCmd[calf].tau;
  }
  bool same(int motor) const {
    return command.motorCmd[motor].tau == unlimited_command.motorCmd[motor].tau;
  }

  Robot robot = quadruped();
  StandController free, limited;
  RunawayLegs legs;
  LowState report = resting_sample(robot, 0);
  LowCmd unlimited_command, command;
  double rise = 0.0;  // [W] power rise of that leg with the unlimited torques
  float along = 1.0F;
};

BOOST_AUTO_TEST_CASE(only_a_runaway_leg_is_limited_to_its_power_share) {
  RunawayScene robot(40.0);
  robot.accelerate_leg();
  BOOST_TEST(robot.rise > 1.2 * 10.0);
  BOOST_TEST(std::abs(robot.torque_ratio(0) * robot.rise - 10.0) < 0.3);
  BOOST_TEST((robot.limited.status() == Status::kSaturated));
  BOOST_TEST(robot.limited.power_scale() == 1.0);
  BOOST_TEST(robot.limited.command_power() < robot.free.command_power());
  for (int leg = 1; leg < kLegs; ++leg) BOOST_TEST(std::abs(robot.torque_ratio(leg) - 1.0) < 0.02);
  for (int k = 0; k < 10; ++k) robot.step(1.8F);
  BOOST_TEST(std::abs(robot.torque_ratio(0) - 1.0) < 0.02);
  BOOST_TEST((robot.limited.status() == Status::kOk));
}

BOOST_AUTO_TEST_CASE(power_limit_above_the_rise_leaves_torques_identical) {
  RunawayScene probe(1e6);
  probe.accelerate_leg();
  RunawayScene above(1.02 * kLegs * probe.rise), below(0.98 * kLegs * probe.rise);
  above.accelerate_leg();
  below.accelerate_leg();
  for (int i = 0; i < kMotors; ++i) BOOST_TEST((probe.same(i) && above.same(i)));
  BOOST_TEST(!below.same(FR_2));
}

BOOST_AUTO_TEST_CASE(lost_leg_is_not_checked_for_runaway) {
  RunawayScene robot(2.0);  // the lost leg's torques are small, and not sent at all
  for (StandController* c : {&robot.free, &robot.limited}) c->declare_leg_lost(0);
  for (int k = 0; k < 5; ++k) robot.step(0.0F);
  const int calf = robot.robot.motor_to_v()[FR_2] - 6;
  robot.along = robot.free.solution().torques[calf] > 0.0 ? 1.0F : -1.0F;
  for (int k = 1; k <= 3; ++k) {
    robot.step(0.6F * static_cast<float>(k));
    BOOST_TEST((robot.limited.status() == robot.free.status()));
    BOOST_TEST(robot.limited.command_power() == robot.free.command_power());
  }
}

// A landing leg brakes as it takes the weight of the body; when it starts to drive, the body is
// slow.
BOOST_AUTO_TEST_CASE(landing_leg_is_not_a_runaway_leg) {
  RunawayLegs legs;
  double most = 0.0;
  for (int k = 0; k < 200; ++k) {  // critically damped from 5 rad/s, 10 N.m per motor
    const double t = k * kTick, w = 20.0;
    legs.update(Vector12::Constant(5.0 * (w * t - 1.0) * std::exp(-w * t)), kTick);
    most = std::max(most, legs.power_rise(Vector12::Constant(10.0), 0));
  }
  BOOST_TEST(most < 90.0 / 4.0);
}

// The front right leg swings and accelerates, as planned.
BOOST_AUTO_TEST_CASE(leg_that_the_planner_swings_is_not_limited) {
  const Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Reference reference = reference_at(robot, state);
  const Vector12 tau = Vector12::Constant(5.0);
  const auto is_limited = [&](bool stepping) {
    reference.stepping = stepping;
    reference.feet[FR_].stance = false;
    TorqueCommand command(robot, 0.0, 40.0);
    for (int k = 0; k < 5; ++k) {
      state.v[robot.motor_to_v()[FR_1]] = 0.6 * k;
      command.observe_joints(state, kTick);
    }
    return command.set_torques(tau, 0.0, dynamics_at(robot, state), state, reference, Gains());
  };
  BOOST_TEST(is_limited(false));
  BOOST_TEST(!is_limited(true));
}

BOOST_AUTO_TEST_SUITE_END()
