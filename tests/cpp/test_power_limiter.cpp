// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "dynamics/dynamics.hpp"
#include "pushed_robot.hpp"
#include "random_disturbances.hpp"
#include "robot_states.hpp"
#include "safety/holding_torques.hpp"
#include "safety/power_limiter.hpp"
#include "safety/torque_command.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_controller.hpp"
#include "tick/controller_access.hpp"

using namespace surefoot;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kLimit = 300.0;  // [W] power limit of the controller

struct Demand {
  explicit Demand(int seed) {
    std::mt19937 generator(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < kMotors; ++i) {
      tau[i] = 30.0 * uniform(generator);
      hold[i] = 10.0 * uniform(generator);
      dq[i] = 8.0 * uniform(generator);
    }
  }
  double power(double s, double damping = 0.0) const {
    const Vector12 made = hold + s * (tau - hold) - damping * dq;
    return made.cwiseProduct(dq).cwiseAbs().sum();
  }
  Vector12 tau, hold, dq;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(power_limiter)

BOOST_AUTO_TEST_CASE(torques_within_the_limit_are_unchanged) {
  for (int seed = 0; seed < 50; ++seed) {
    const Demand d(seed);
    for (const double limit : {kInf, d.power(1.0) * (1.0 + 1e-12)}) {
      const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, limit);
      BOOST_TEST((out.torques == d.tau && out.scale == 1.0 && !out.no_scale_within_limit));
      BOOST_TEST(out.power == d.power(1.0), boost::test_tools::tolerance(1e-12));
    }
  }
}

// Compare with a fine grid of scales, for limits from 0 to 90 % of the full power.
BOOST_AUTO_TEST_CASE(scale_is_the_largest_within_the_limit) {
  int limited = 0, exceeded_at_hold = 0, exceeded = 0;
  for (int seed = 0; seed < 200; ++seed) {
    const Demand d(seed);
    const double damping = seed % 2 ? 0.5 : 0.0, limit = d.power(1.0, damping) * (seed % 10) / 10.0;
    const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, limit, damping);
    double greatest = -1.0;
    for (int k = 0; k <= 2000; ++k) {
      if (d.power(k / 2000.0, damping) <= limit) greatest = k / 2000.0;
    }
    if (out.no_scale_within_limit) {
      BOOST_TEST((greatest < 0.0 && out.scale == 0.0 && out.torques == d.hold));
      ++exceeded;
      continue;
    }
    BOOST_TEST(out.scale >= greatest);
    BOOST_TEST((greatest < 0.0 || out.scale < greatest + 1.0 / 2000.0));
    BOOST_TEST(out.power <= limit);
    BOOST_TEST(out.power > limit * (1.0 - 1e-9));
    BOOST_TEST((out.torques - (d.hold + out.scale * (d.tau - d.hold))).norm() < 1e-12);
    ++limited;
    exceeded_at_hold += d.power(0.0, damping) > limit;
  }
  BOOST_TEST((limited > 50 && exceeded_at_hold > 5 && exceeded > 20));
}

BOOST_AUTO_TEST_CASE(holding_torques_above_the_limit_are_reported) {
  Demand d(1);
  d.tau = 2.0 * d.hold;
  const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, 0.5 * d.power(0.0));
  BOOST_TEST((out.no_scale_within_limit && out.scale == 0.0 && out.torques == d.hold));
  BOOST_TEST(out.power == d.power(0.0), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(non_finite_input_gives_finite_holding_torques) {
  for (const double bad : {std::nan(""), kInf, -kInf}) {
    for (int field = 0; field < 3; ++field) {
      Demand d(3);
      const Vector12 hold = d.hold;
      (field == 0 ? d.tau : field == 1 ? d.hold : d.dq)[7] = bad;
      for (const double limit : {50.0, kInf}) {
        const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, limit);
        BOOST_TEST((out.no_scale_within_limit && out.scale == 0.0 && out.torques.allFinite()));
        BOOST_TEST(out.torques[7] == (field == 1 ? 0.0 : hold[7]));
        BOOST_TEST(out.torques.head<7>() == hold.head<7>());
      }
    }
  }
  const Demand d(3);
  BOOST_TEST(limit_power(d.tau, d.hold, d.dq, std::nan("")).no_scale_within_limit);
  BOOST_TEST(limit_power(d.tau, d.hold, d.dq, -1.0).no_scale_within_limit);
}

// A pair of legs swings and all motors drive. With an evenly scaled command, the stance legs would
// lose torque that they need to hold the robot.
BOOST_AUTO_TEST_CASE(swing_legs_lose_power_before_the_legs_that_carry) {
  const Robot robot = quadruped();
  RobotState state = standing_state(robot);
  for (int i = 0; i < kMotors; ++i) state.v[robot.motor_to_v()[i]] = 2.0;
  Reference reference = reference_at(robot, state);
  reference.stepping = true;
  for (const int leg : {FR_, RL_}) reference.feet[leg].stance = false;
  Vector12 tau = Vector12::Constant(5.0);
  const Vector12 dq = Vector12::Constant(2.0);
  const double full = power_of(tau, dq, 0.0);
  const auto limited = [&](double watts) {
    TorqueCommand command(robot, 0.0, watts);
    command.set_torques(tau, 0.0, dynamics_at(robot, state), state, reference, Gains());
    return command.limited();
  };
  const auto leg = [](const LimitedTorques& out, int k) { return out.torques.segment<3>(3 * k); };
  const LimitedTorques little = limited(0.8 * full);
  BOOST_TEST((little.scale == 1.0 && little.swing_scale > 0.0 && little.swing_scale < 1.0));
  BOOST_TEST((leg(little, FL_) == leg({tau}, FL_) && leg(little, RR_) == leg({tau}, RR_)));
  BOOST_TEST(leg(little, FR_).norm() < 0.9 * leg({tau}, FR_).norm());
  const LimitedTorques much = limited(0.45 * full);
  BOOST_TEST((much.swing_scale == 0.0 && much.scale < 1.0 && much.power <= 0.45 * full));
  // The swing legs take more power with their holding torques, so these would not help.
  for (const int swinging : {FR_, RL_}) tau.segment<3>(3 * swinging).setZero();
  const LimitedTorques brakes = limited(0.45 * full);
  BOOST_TEST((brakes.scale < 1.0 && brakes.power <= 0.45 * full && !brakes.swings[FR_]));
  tau.setConstant(5.0);
  reference.stepping = false;
  BOOST_TEST(limited(0.8 * full).scale < 1.0);
}

// The state of set_torques() may be predicted, and wrong. With damping, the power is not largest at
// the larger speed.
BOOST_AUTO_TEST_CASE(power_is_limited_at_the_present_speed_too) {
  const Robot& robot = quadruped();
  const double watts = 50.0, damping = 0.5;
  const auto state_at = [&](double speed) {
    RobotState state = standing_state(robot);
    state.v[robot.motor_to_v()[4]] = speed;
    return state;
  };
  const auto power_at = [&](const Vector12& tau, double speed) {
    return power_of(tau, speed * Vector12::Unit(4), damping);
  };
  for (const auto& [present, predicted] :
       {std::pair{5.0, 0.0}, {0.0, 5.0}, {5.0, 10.0}, {-5.0, 6.0}, {4.0, -4.0}}) {
    const RobotState state = state_at(predicted);
    TorqueCommand command(robot, damping, watts);
    command.observe_joints(state_at(present), 0.002);
    BOOST_TEST(command.set_torques(Vector12::Constant(40.0), 0.0, dynamics_at(robot, state), state,
                                   Reference(), Gains()));
    const LimitedTorques& limited = command.limited();
    BOOST_TEST((limited.scale > 0.0 && limited.scale < 1.0));
    BOOST_TEST(power_at(limited.torques, present) <= watts + 1e-9);
    BOOST_TEST(power_at(limited.torques, predicted) <= watts + 1e-9);
    BOOST_TEST(std::abs(limited.power - power_at(limited.torques, predicted)) < 1e-9);
  }
}

// At this present speed even the holding torques exceed the limit; the predicted one still counts.
BOOST_AUTO_TEST_CASE(power_is_limited_at_the_predicted_speed_if_not_at_the_present_one) {
  const Robot& robot = quadruped();
  RobotState present = standing_state(robot), predicted = present;
  for (int i = 0; i < kMotors; ++i) present.v[robot.motor_to_v()[i]] = 50.0;
  for (int i = 0; i < kMotors; ++i) predicted.v[robot.motor_to_v()[i]] = 0.5;
  TorqueCommand command(robot, 0.0, 50.0);
  command.observe_joints(present, 0.002);
  command.set_torques(Vector12::Constant(20.0), 0.0, dynamics_at(robot, predicted), predicted,
                      Reference(), Gains());
  BOOST_TEST(command.limited().power <= 50.0 + 1e-9);
}

BOOST_AUTO_TEST_CASE(holding_torques_balance_gravity) {
  const Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  const Vector12 hold = holding_torques(dynamics, robot.mass(), state, Eigen::Vector4d::Ones());
  // In equilibrium h = S' tau + J' f, with the forces that follow from the torques.
  Vector6 left = dynamics.h_base();
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& one = dynamics.legs()[leg];
    const Vector3 rest = one.h_leg - hold.segment<3>(3 * leg);
    const Vector3 force = one.J_leg.transpose().inverse() * rest;
    BOOST_TEST(force.z() > 0.15 * robot.mass() * kGravity);
    left -= one.J_base.transpose() * force;
  }
  BOOST_TEST(left.norm() < 1e-6);
}

BOOST_AUTO_TEST_CASE(controller_command_keeps_the_power_limit_or_is_saturated) {
  const Robot robot = quadruped();
  ControllerOptions options;
  options.power_limit = kLimit;
  Gains gains;
  gains.recovery_margin =
      -10.0;  // no steps: while feet step, the power is that of predicted speeds
  StandController free(robot, gains), limited(robot, gains, options);
  for (StandController* c : {&free, &limited}) ControllerAccess::end_sensor_check(*c);
  RandomDisturbances disturbances(robot);
  int scaled = 0, above = 0;
  for (std::uint32_t tick = 1; tick < 960; ++tick) {
    const LowState report = disturbances.report(tick);
    free.update(report);
    const LowCmd cmd = limited.update(report);
    BOOST_REQUIRE(is_usable(limited.status()));
    double power = 0.0;
    for (int i = 0; i < kMotors; ++i) {
      power += std::abs(static_cast<double>(cmd.motorCmd[i].tau) * report.motorState[i].dq);
    }
    BOOST_REQUIRE(std::abs(power - limited.command_power()) < 1e-3);
    if (limited.power_scale() < 1.0) BOOST_REQUIRE((limited.status() == Status::kSaturated));
    if (limited.power_scale() < 1.0) BOOST_REQUIRE(limited.command_power() <= kLimit);
    scaled += limited.power_scale() < 1.0;
    above += limited.command_power() > kLimit;
    BOOST_REQUIRE(free.power_scale() == 1.0);
  }
  BOOST_TEST(scaled > 10);
  BOOST_TEST(above < scaled);
  limited.reset();
  BOOST_TEST((limited.command_power() == 0.0 && limited.power_scale() == 1.0));
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    options.power_limit = wrong;
    BOOST_CHECK_THROW(StandController(robot, Gains(), options), Error);
  }
}

BOOST_AUTO_TEST_SUITE_END()
