// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <limits>
#include <random>

#include "dynamics/dynamics.hpp"
#include "safety/flung_legs.hpp"
#include "safety/holding_torques.hpp"
#include "safety/power_limiter.hpp"
#include "scenes.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_controller.hpp"
#include "weather.hpp"

using namespace surefoot;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kLimit = 300.0;  // [W] of the controller under test

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

BOOST_AUTO_TEST_CASE(torques_within_the_limit_are_not_changed_by_a_bit) {
  for (int seed = 0; seed < 50; ++seed) {
    const Demand d(seed);
    for (const double limit : {kInf, d.power(1.0) * (1.0 + 1e-12)}) {
      const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, limit);
      BOOST_TEST((out.torques == d.tau && out.scale == 1.0 && !out.exceeds));
      BOOST_TEST(out.power == d.power(1.0), boost::test_tools::tolerance(1e-12));
    }
  }
}

// Against every point of a fine grid, with limits from far too little to nearly enough.
BOOST_AUTO_TEST_CASE(the_scale_is_the_greatest_that_is_within_the_limit) {
  int limited = 0, dipped = 0, exceeded = 0;
  for (int seed = 0; seed < 200; ++seed) {
    const Demand d(seed);
    const double damping = seed % 2 ? 0.5 : 0.0, limit = d.power(1.0, damping) * (seed % 10) / 10.0;
    const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, limit, damping);
    double greatest = -1.0;
    for (int k = 0; k <= 2000; ++k) {
      if (d.power(k / 2000.0, damping) <= limit) greatest = k / 2000.0;
    }
    if (out.exceeds) {
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
    dipped += d.power(0.0, damping) > limit;
  }
  BOOST_TEST((limited > 50 && dipped > 5 && exceeded > 20));
}

BOOST_AUTO_TEST_CASE(where_holding_alone_is_too_much_it_is_said) {
  Demand d(1);
  d.tau = 2.0 * d.hold;
  const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, 0.5 * d.power(0.0));
  BOOST_TEST((out.exceeds && out.scale == 0.0 && out.torques == d.hold));
  BOOST_TEST(out.power == d.power(0.0), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(what_is_no_number_ends_in_holding_and_never_goes_on) {
  for (const double bad : {std::nan(""), kInf, -kInf}) {
    for (int field = 0; field < 3; ++field) {
      Demand d(3);
      const Vector12 hold = d.hold;
      (field == 0 ? d.tau : field == 1 ? d.hold : d.dq)[7] = bad;
      for (const double limit : {50.0, kInf}) {
        const LimitedTorques out = limit_power(d.tau, d.hold, d.dq, limit);
        BOOST_TEST((out.exceeds && out.scale == 0.0 && out.torques.allFinite()));
        BOOST_TEST(out.torques[7] == (field == 1 ? 0.0 : hold[7]));
        BOOST_TEST(out.torques.head<7>() == hold.head<7>());
      }
    }
  }
  const Demand d(3);
  BOOST_TEST(limit_power(d.tau, d.hold, d.dq, std::nan("")).exceeds);
  BOOST_TEST(limit_power(d.tau, d.hold, d.dq, -1.0).exceeds);
}

BOOST_AUTO_TEST_CASE(holding_torques_carry_the_weight_and_nothing_else) {
  const Robot robot = quadruped();
  RobotState state = standing_state(robot);
  Dynamics dynamics(robot);
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  const Vector12 hold = holding_torques(dynamics, robot.mass(), state, Eigen::Vector4d::Ones());
  // In equilibrium: h = S' tau + J' f with forces that the torques themselves tell.
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

BOOST_AUTO_TEST_CASE(a_controllers_command_keeps_to_its_limit_or_says_so) {
  const Robot robot = quadruped();
  StandOptions options;
  options.power_limit = kLimit;
  StandController free(robot), limited(robot, Gains(), options);
  Weather weather(robot);
  int scaled = 0, above = 0;
  for (std::uint32_t tick = 1; tick < 960; ++tick) {
    const LowState report = weather.report(tick);
    free.update(report);
    const LowCmd cmd = limited.update(report);
    BOOST_REQUIRE(is_usable(limited.status()));
    double power = 0.0;
    for (int i = 0; i < kMotors; ++i) {
      power += std::abs(static_cast<double>(cmd.motorCmd[i].tau) * report.motorState[i].dq);
    }
    BOOST_REQUIRE(std::abs(power - limited.power()) < 1e-3);
    if (limited.power_scale() < 1.0) BOOST_REQUIRE((limited.status() == Status::kSaturated));
    if (limited.power_scale() < 1.0) BOOST_REQUIRE(limited.power() <= kLimit);
    scaled += limited.power_scale() < 1.0;
    above += limited.power() > kLimit;
    BOOST_REQUIRE(free.power_scale() == 1.0);
  }
  BOOST_TEST(scaled > 10);
  BOOST_TEST(above < scaled);
  limited.reset();
  BOOST_TEST((limited.power() == 0.0 && limited.power_scale() == 1.0));
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    options.power_limit = wrong;
    BOOST_CHECK_THROW(StandController(robot, Gains(), options), Error);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(flung_legs)

constexpr double kTick = 0.002;  // [s]

// FR's thigh gathers ddq [rad/s^2] from dq [rad/s] on for 10 ticks: by how much its power rises.
double rise(double ddq, double tau, double dq = 0.0) {
  FlungLegs legs;
  Vector12 speeds = Vector12::Constant(0.1), torques = Vector12::Constant(5.0);
  torques[1] = tau;
  for (int k = 0; k < 10; ++k) {
    speeds[1] = dq + k * kTick * ddq;
    legs.update(speeds, kTick);
  }
  BOOST_TEST(legs.rise(torques, 1) == 0.0);
  return legs.rise(torques, 0);
}

BOOST_AUTO_TEST_CASE(a_leg_rises_in_power_where_its_torques_drive_it) {
  const auto percent = boost::test_tools::tolerance(0.01);
  BOOST_TEST(rise(0.0, 10.0) == 0.0);
  BOOST_TEST(rise(200.0, 10.0) == 10.0 * 200.0 * 0.015, percent);
  BOOST_TEST(rise(-200.0, -10.0) == 10.0 * 200.0 * 0.015, percent);
  BOOST_TEST(rise(200.0, -10.0) == 0.0);        // they brake it
  BOOST_TEST(rise(200.0, 10.0, -10.0) == 0.0);  // they still do in 15 ms
  // -2.4 rad/s by now, 3.6 in 15 ms: they drive it from rest on.
  BOOST_TEST(rise(400.0, 10.0, -9.6) == 10.0 * 3.6, percent);
}

BOOST_AUTO_TEST_CASE(what_is_not_known_flings_no_leg) {
  const Vector12 torques = Vector12::Constant(10.0);
  FlungLegs legs;
  const auto after = [&](double dq, double dt) {
    legs.update(Vector12::Constant(dq), dt);
    return legs.rise(torques, 2);
  };
  BOOST_TEST(after(3.0, kTick) == 0.0);  // the first
  BOOST_TEST(after(3.5, kTick) > 10.0);
  BOOST_TEST(after(4.0, 0.010) == 0.0);  // a gap, as long as a gap is ever told
  BOOST_TEST(after(4.5, kTick) > 10.0);
  BOOST_TEST(after(std::nan(""), kTick) == 0.0);
  BOOST_TEST(after(4.5, kTick) == 0.0);
  BOOST_TEST(after(5.0, kTick) > 10.0);
  legs.reset();
  BOOST_TEST(after(6.0, kTick) == 0.0);
}

// Noise of an encoder's speed, 0.05 rad/s, at the torques of a stand: far below a leg's share of
// the least power there is, 90 W / 4.
BOOST_AUTO_TEST_CASE(noise_flings_no_leg) {
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 0.05);
  double most = 0.0;
  for (const double dt : {0.001, kTick}) {
    FlungLegs legs;
    for (int k = 0; k < 100000; ++k) {
      Vector12 dq;
      for (double& speed : dq) speed = noise(generator);
      legs.update(dq, dt);
      most = std::max(most, legs.rise(Vector12::Constant(8.0), 0));
    }
  }
  BOOST_TEST(most < 0.9 * 90.0 / 4.0);
}

/// Two controllers, one of them with a limit, on a robot whose right fore calf gathers speed.
struct Flung {
  explicit Flung(double watts) : free(robot), limited(robot, robot.config().gains, with(watts)) {
    for (int k = 0; k < 20; ++k) step(0.0);
    along = command.motorCmd[FR_2].tau > 0.0F ? 1.0F : -1.0F;
  }
  static StandOptions with(double watts) {
    StandOptions options;
    options.power_limit = watts;
    return options;
  }
  void step(float dq) {
    report.tick += 2;
    report.motorState[FR_2].dq = along * dq;
    whole = free.update(report);
    command = limited.update(report);
  }
  /// What a leg is left of its torques.
  double left(int leg) const {
    const int calf = kLegJoints * leg + 2;
    return command.motorCmd[calf].tau / whole.motorCmd[calf].tau;
  }
  Robot robot = quadruped();
  StandController free, limited;
  LowState report = resting_report(robot, 0);
  LowCmd whole, command;
  float along = 1.0F;
};

BOOST_AUTO_TEST_CASE(a_flung_leg_and_no_other_gets_less_and_only_while_it_is) {
  Flung robot(40.0);
  for (int k = 1; k <= 3; ++k) robot.step(0.6F * static_cast<float>(k));
  BOOST_TEST(robot.left(0) < 0.9);
  BOOST_TEST((robot.limited.status() == Status::kSaturated));
  BOOST_TEST(robot.limited.power_scale() == 1.0);
  BOOST_TEST(robot.limited.power() < robot.free.power());
  for (int leg = 1; leg < kLegs; ++leg) BOOST_TEST(std::abs(robot.left(leg) - 1.0) < 0.02);
  for (int k = 0; k < 10; ++k) robot.step(1.8F);
  BOOST_TEST(std::abs(robot.left(0) - 1.0) < 0.02);
  BOOST_TEST((robot.limited.status() == Status::kOk));
}

BOOST_AUTO_TEST_CASE(a_limit_far_above_what_a_leg_takes_changes_not_a_bit) {
  Flung robot(4000.0);
  for (int k = 1; k <= 3; ++k) {
    robot.step(0.6F * static_cast<float>(k));
    for (int i = 0; i < kMotors; ++i) {
      BOOST_TEST(robot.command.motorCmd[i].tau == robot.whole.motorCmd[i].tau);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
