// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <limits>

#include "gait/velocity_command.hpp"
#include "quadruped.hpp"

using namespace surefoot;

namespace {

const double kNan = std::nan("");
const double kInfinity = std::numeric_limits<double>::infinity();

struct CommandFixture {
  Gains gains;
  GaitSize size{quadruped()};
  VelocityCommand command{size, 0.5, kInfinity};
  Gait gait = Gait::kAuto;
  WalkLimit set(double vx, double vy, double yaw_rate) {
    command.set(gains, gait, {vx, vy, yaw_rate});
    return command.limit();
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_velocity_command)

BOOST_FIXTURE_TEST_CASE(velocity_within_reach_is_kept, CommandFixture) {
  BOOST_TEST(command.is_zero());
  BOOST_TEST((set(0.4, -0.2, 0.3) == WalkLimit::kNone));
  const WalkVelocity& v = command.velocity();
  BOOST_TEST((v.vx == 0.4 && v.vy == -0.2 && v.yaw_rate == 0.3));
  BOOST_TEST(!command.is_zero());
  BOOST_TEST((set(0.0, 0.0, -0.1) == WalkLimit::kNone));
  BOOST_TEST(!command.is_zero());
}

BOOST_FIXTURE_TEST_CASE(velocity_is_clamped_and_its_limit_named, CommandFixture) {
  BOOST_TEST((set(9.0, 0.0, 0.0) == WalkLimit::kForward));
  BOOST_TEST(command.velocity().vx == gains.walk_speed_forward * size.speed);
  BOOST_TEST((set(-9.0, 0.0, 0.0) == WalkLimit::kForward));
  BOOST_TEST(command.velocity().vx == -gains.walk_speed_backward * size.speed);
  for (const double sign : {1.0, -1.0}) {
    BOOST_TEST((set(0.2, sign * 9.0, 0.0) == WalkLimit::kSideways));
    BOOST_TEST(command.velocity().vy == sign * gains.walk_speed_sideways * size.speed);
    BOOST_TEST(command.velocity().vx == 0.2);
    BOOST_TEST((set(0.0, 0.0, sign * 9.0) == WalkLimit::kTurn));
    BOOST_TEST(command.velocity().yaw_rate == sign * gains.walk_turn_speed / size.time);
  }
  BOOST_TEST((set(0.1, 0.0, 0.0) == WalkLimit::kNone));
}

BOOST_FIXTURE_TEST_CASE(walk_has_smaller_limits_with_the_same_names, CommandFixture) {
  gait = Gait::kWalk;
  for (const double sign : {1.0, -1.0}) {
    BOOST_TEST((set(sign * 9.0, 0.0, 0.0) == WalkLimit::kForward));
    BOOST_TEST(command.velocity().vx == sign * gains.walk_gait_speed * size.speed);
    BOOST_TEST((set(0.0, sign * 9.0, 0.0) == WalkLimit::kSideways));
    BOOST_TEST(command.velocity().vy == sign * gains.walk_gait_speed * size.speed);
    BOOST_TEST((set(0.0, 0.0, sign * 9.0) == WalkLimit::kTurn));
    BOOST_TEST(command.velocity().yaw_rate == sign * gains.walk_gait_turn_speed / size.time);
  }
}

BOOST_FIXTURE_TEST_CASE(combined_velocity_keeps_its_path_and_the_sum_of_its_shares_is_limited,
                        CommandFixture) {
  const double vx = gains.walk_speed_forward * size.speed;
  const double vy = gains.walk_speed_sideways * size.speed;
  const double yaw_rate = gains.walk_turn_speed / size.time;
  BOOST_TEST((set(0.5 * vx, -0.5 * vy, 0.1 * yaw_rate) == WalkLimit::kNone));
  BOOST_TEST((set(vx, -vy, 0.0) == WalkLimit::kCombination));
  BOOST_TEST(command.velocity().vx == 0.575 * vx, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(command.velocity().vy == -0.575 * vy, boost::test_tools::tolerance(1e-9));
  gait = Gait::kWalk;
  BOOST_TEST((set(9.0, 9.0, 0.0) == WalkLimit::kCombination));
  BOOST_TEST(command.velocity().vx == std::sqrt(0.5) * gains.walk_gait_speed * size.speed,
             boost::test_tools::tolerance(1e-9));
}

BOOST_FIXTURE_TEST_CASE(acceleration_in_a_curve_is_limited, CommandFixture) {
  gains.walk_acceleration = 0.05;  // [g]
  BOOST_TEST((set(0.5 * size.speed, 0.0, 0.2 / size.time) == WalkLimit::kCombination));
  const WalkVelocity& v = command.velocity();
  BOOST_TEST(v.vx * v.yaw_rate == 0.05 * kGravity, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(v.vx * size.time == 2.5 * size.speed * v.yaw_rate * size.time * size.time,
             boost::test_tools::tolerance(1e-9));
}

BOOST_FIXTURE_TEST_CASE(velocity_that_is_not_finite_keeps_the_last_one, CommandFixture) {
  set(0.4, 0.0, 0.3);
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    BOOST_TEST((set(bad, 0.0, 0.0) == WalkLimit::kNotFinite));
    BOOST_TEST((set(0.0, bad, 0.0) == WalkLimit::kNotFinite));
    BOOST_TEST((set(0.0, 0.0, bad) == WalkLimit::kNotFinite));
    BOOST_TEST((command.velocity().vx == 0.4 && command.velocity().yaw_rate == 0.3));
  }
}

BOOST_FIXTURE_TEST_CASE(velocity_is_zero_after_its_timeout, CommandFixture) {
  const auto advance = [&](double seconds) {
    for (int k = 0; k < seconds / 0.01 - 0.5; ++k) command.advance(0.01);
  };
  set(0.4, 0.0, 0.0);
  advance(0.4);
  set(0.4, 0.0, 0.0);  // the time starts again
  advance(0.49);
  BOOST_TEST(!command.is_zero());
  advance(0.03);
  BOOST_TEST(command.is_zero());
  // A command that is ignored does not renew the last one.
  set(0.4, 0.0, 0.0);
  advance(0.3);
  set(kNan, 0.0, 0.0);
  advance(0.22);
  BOOST_TEST(command.is_zero());
}

BOOST_FIXTURE_TEST_CASE(reset_sets_the_velocity_to_zero, CommandFixture) {
  set(9.0, 0.0, 0.0);
  command.reset();
  BOOST_TEST(command.is_zero());
  BOOST_TEST((command.limit() == WalkLimit::kNone));
}

BOOST_FIXTURE_TEST_CASE(velocity_is_clamped_to_what_the_power_limit_carries, CommandFixture) {
  const double power = gains.walk_power_rest + 0.125 * gains.walk_power_rise;
  VelocityCommand limited(size, 0.5, power);
  limited.set(gains, Gait::kAuto, {0.49 * size.speed, 0.0, 0.0});
  BOOST_TEST((limited.limit() == WalkLimit::kNone));
  limited.set(gains, Gait::kAuto, {0.6 * size.speed, 0.0, 0.0});
  BOOST_TEST((limited.limit() == WalkLimit::kPower));
  BOOST_TEST(limited.velocity().vx == 0.5 * size.speed, boost::test_tools::tolerance(1e-9));
  // A turn moves the hips too; direction and curvature stay.
  limited.set(gains, Gait::kAuto, {0.4 * size.speed, 0.2 * size.speed, 0.4 / size.time});
  BOOST_TEST(size.fastest_hip(limited.velocity()) == 0.5 * size.speed,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(limited.velocity().vx == 2.0 * limited.velocity().vy,
             boost::test_tools::tolerance(1e-9));
}

BOOST_FIXTURE_TEST_CASE(robot_whose_power_limit_is_too_small_for_a_trot_gets_no_velocity,
                        CommandFixture) {
  VelocityCommand limited(size, 0.5, 0.9 * gains.walk_power_rest);
  limited.set(gains, Gait::kAuto, {0.3 * size.speed, 0.0, 0.0});
  BOOST_TEST((limited.limit() == WalkLimit::kPower));
  BOOST_TEST(limited.is_zero());
  limited.set(gains, Gait::kAuto, {});
  BOOST_TEST((limited.limit() == WalkLimit::kNone));
  BOOST_TEST(limited.is_zero());  // and not NaN
}

BOOST_AUTO_TEST_SUITE_END()
