// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "gait/gait_timing.hpp"
#include "quadruped.hpp"

using namespace surefoot;

namespace {

// Return the size of a robot whose lengths are `factor` times those of `size`, with similar motors.
GaitSize scaled(GaitSize size, double factor) {
  size.nominal_feet *= factor;
  size.height *= factor;
  size.time *= std::sqrt(factor);
  size.speed *= std::sqrt(factor);
  size.corner_speed /= std::sqrt(factor);
  return size;
}

struct TimingFixture {
  Gains gains;
  GaitSize size{quadruped()};
  GaitTiming at_speed(double vx) const { return gait_timing({}, gains, size, {vx, 0.0, 0.0}); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_times)

BOOST_FIXTURE_TEST_CASE(size_of_the_robot_is_that_of_its_standing_pose, TimingFixture) {
  BOOST_TEST(std::abs(size.time * size.time * kGravity - size.height) < 1e-12);
  BOOST_TEST(std::abs(size.speed * size.time - size.height) < 1e-12);
  // Centre of mass below the hips, which are 0.4 cos(0.8) m above the centres of the feet.
  BOOST_TEST(size.height > 0.2);
  BOOST_TEST(size.height < 0.4 * std::cos(0.8) + 0.02);
  BOOST_TEST(std::abs(size.nominal_feet(1, FL_) - 0.13) < 1e-9);
  BOOST_TEST(size.corner_speed == 12.0);
}

BOOST_FIXTURE_TEST_CASE(slow_trot_has_the_period_and_duty_of_the_gains, TimingFixture) {
  for (const double vx : {0.0, 0.3, -0.3}) {
    BOOST_TEST(std::abs(at_speed(vx).period - gains.gait_period * size.time) < 1e-12);
    BOOST_TEST(at_speed(vx).duty == gains.gait_duty);
  }
}

BOOST_FIXTURE_TEST_CASE(period_shortens_so_that_the_stance_travel_is_kept, TimingFixture) {
  double last = at_speed(0.0).period;
  for (double vx = 0.1; vx < 3.0; vx += 0.1) {
    const GaitTiming timing = at_speed(vx);
    const double travel = vx * timing.stance_time();
    BOOST_REQUIRE(travel < gains.gait_stance_travel * size.height + 1e-9);
    BOOST_REQUIRE(timing.period <= last + 1e-12);
    last = timing.period;
  }
  BOOST_TEST(std::abs(2.0 * at_speed(2.0).stance_time() - gains.gait_stance_travel * size.height) <
             1e-9);
}

// A swing foot moves past the body with 15/8 of its mean speed, less the speed of the body.
BOOST_FIXTURE_TEST_CASE(duty_falls_so_that_the_swing_speed_is_kept, TimingFixture) {
  const double most = gains.gait_swing_speed * size.height * size.corner_speed;
  bool flies = false;
  for (double vx = 0.1; vx < 3.0; vx += 0.1) {
    const GaitTiming timing = at_speed(vx);
    const double peak = 1.875 * vx * timing.period / timing.swing_time() - vx;
    const bool at_smallest_duty = timing.duty < 0.45 / 1.45 + 1e-9;
    BOOST_REQUIRE((peak < most + 1e-9 || at_smallest_duty));
    flies = flies || timing.duty < 0.5;
  }
  BOOST_TEST(flies);
  BOOST_TEST(std::abs(at_speed(50.0).duty - 0.45 / 1.45) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(turning_counts_as_the_speed_of_the_fastest_hip, TimingFixture) {
  const double arm = size.nominal_feet.topRows<2>().colwise().norm().maxCoeff();
  for (const double yaw_rate : {9.0, -9.0}) {
    const GaitTiming turning = gait_timing({}, gains, size, {0.0, 0.0, yaw_rate});
    BOOST_TEST(turning.period < gains.gait_period * size.time);
    BOOST_TEST(std::abs(turning.period - at_speed(9.0 * arm).period) < 1e-12);
    BOOST_TEST(std::abs(turning.duty - at_speed(9.0 * arm).duty) < 1e-12);
  }
  const GaitTiming sideways = gait_timing({}, gains, size, {0.6, -0.8, 0.0});
  BOOST_TEST(std::abs(sideways.period - at_speed(1.0).period) < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(feet_of_a_walk_lift_off_in_order_a_quarter_of_the_period_apart,
                        TimingFixture) {
  for (const WalkOrder& order : {WalkOrder{RR_, FR_, RL_, FL_}, WalkOrder{RR_, RL_, FR_, FL_}}) {
    const GaitTiming timing = gait_timing({true, order}, gains, size, {0.1, 0.0, 0.0});
    BOOST_TEST(timing.duty == gains.walk_gait_duty);
    for (int k = 0; k < kLegs; ++k) {
      const double lift_off = timing.duty - timing.offset[order[k]];  // phase of the clock
      BOOST_TEST(std::abs(std::remainder(lift_off - 0.25 * (k + 1), 1.0)) < 1e-12);
    }
  }
}

// One foot swings at a time, whatever the speed.
BOOST_FIXTURE_TEST_CASE(walk_keeps_three_legs_down_at_every_speed, TimingFixture) {
  for (double vx = 0.0; vx < 3.0; vx += 0.1) {
    const GaitTiming timing = gait_timing({true, {}}, gains, size, {vx, 0.0, 0.0});
    BOOST_REQUIRE(timing.duty >= 0.75);
    BOOST_REQUIRE(timing.period <= gains.walk_gait_period * size.time + 1e-12);
    BOOST_REQUIRE(vx * timing.stance_time() < gains.gait_stance_travel * size.height + 1e-9);
  }
}

// The gains have units of h and g, so similar robots have similar gaits. A b1 is 1.8 times an a1.
BOOST_FIXTURE_TEST_CASE(timing_scales_with_the_size_of_the_robot, TimingFixture) {
  for (const double factor : {0.5, 1.8}) {
    const GaitSize other = scaled(size, factor);
    for (const double froude : {0.0, 0.3, 0.6, 1.0, 1.5}) {
      const GaitTiming a = gait_timing({}, gains, size, {froude * size.speed, 0.0, 0.0});
      const GaitTiming b = gait_timing({}, gains, other, {froude * other.speed, 0.0, 0.0});
      BOOST_TEST(std::abs(a.duty - b.duty) < 1e-12);
      BOOST_TEST(std::abs(a.period / size.time - b.period / other.time) < 1e-9);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
