// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "gait/foothold.hpp"
#include "walking_body.hpp"

using namespace surefoot;

namespace {

constexpr double kTimeLeft = 0.12, kStanceTime = 0.2;  // [s]

struct FootholdFixture : WalkingBody {
  Eigen::Vector2d of(int leg) const {
    return foothold(gains, size, measured, body, leg, kTimeLeft, kStanceTime);
  }
  // Return the hip of a leg at a time from now, if the body goes on as it does.
  Eigen::Vector2d hip(int leg, double time) const {
    const Eigen::Rotation2Dd R(body.yaw() + time * body.velocity().yaw_rate);
    return measured.p_com + time * measured.v_com + R * size.nominal_feet.col(leg).head<2>();
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_foothold)

BOOST_FIXTURE_TEST_CASE(foot_is_under_its_hip_at_mid_stance_of_a_steady_walk, FootholdFixture) {
  for (const WalkVelocity& command :
       {WalkVelocity{}, WalkVelocity{0.6, 0.0, 0.0}, WalkVelocity{-0.2, 0.3, 0.0}}) {
    walk(command, 3.0);
    for (int leg = 0; leg < kLegs; ++leg) {
      BOOST_TEST((of(leg) - hip(leg, kTimeLeft + 0.5 * kStanceTime)).norm() < 1e-9);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(left_and_right_feet_are_kept_apart, FootholdFixture) {
  const double yaw = 0.5, gap = 0.2 * size.height;
  const Eigen::Rotation2Dd R(yaw);
  const Eigen::Vector2d across(1.0, 2.0);
  for (const int leg : {FR_, FL_, RR_, RL_}) {
    const double side = leg == FR_ || leg == RR_ ? -1.0 : 1.0;
    const auto kept = [&](double to_its_side) {
      const Eigen::Vector2d place = across + R * Eigen::Vector2d(0.1, side * to_its_side);
      return Eigen::Vector2d(R.inverse() * (keep_apart(size, yaw, leg, place, across) - across));
    };
    for (const double crossed : {-0.1, 0.0, 0.5 * gap}) {
      BOOST_TEST((kept(crossed) - Eigen::Vector2d(0.1, side * gap)).norm() < 1e-9);
    }
    BOOST_TEST((kept(1.5 * gap) - Eigen::Vector2d(0.1, side * 1.5 * gap)).norm() < 1e-9);
  }
}

// A minimum-jerk motion over d in T accelerates by 10 / sqrt(3) d / T^2 at most.
BOOST_AUTO_TEST_CASE(allowed_change_of_a_foothold_would_take_8_g_if_made_at_once) {
  const double dt = 1e-4, time = 0.1;
  const Eigen::Vector2d first(1.0, 2.0), far = first + Eigen::Vector2d(3.0, -4.0);
  Eigen::Vector2d place = first;
  for (int k = 0; k < time / dt - 0.5; ++k) place = within_reach(place, far, time - k * dt, dt);
  const double acceleration = 10.0 / std::sqrt(3.0) * (place - first).norm() / (time * time);
  BOOST_TEST(std::abs(acceleration / kGravity - 8.0) < 0.05);
  const Eigen::Vector2d near = first + Eigen::Vector2d(1e-4, 1e-4);
  BOOST_TEST((within_reach(first, near, time, dt) - near).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(feet_of_a_turning_body_are_placed_for_its_heading_at_mid_stance,
                        FootholdFixture) {
  walk({0.0, 0.0, 1.0}, 3.0);
  for (int leg = 0; leg < kLegs; ++leg) {
    BOOST_TEST((of(leg) - hip(leg, kTimeLeft + 0.5 * kStanceTime)).norm() < 1e-9);
  }
}

// The body is dv * time_left further at touchdown. The feedback adds its share of dv sqrt(h / g).
BOOST_FIXTURE_TEST_CASE(velocity_error_moves_the_foothold, FootholdFixture) {
  walk({0.3, 0.0, 0.0}, 3.0);
  const Eigen::Vector2d before = of(FL_), dv(0.2, -0.3);
  measured.v_com += dv;
  const Eigen::Vector2d moved = of(FL_) - before;
  BOOST_TEST((moved - (kTimeLeft + gains.foothold_feedback * size.time) * dv).norm() < 1e-9);
}

// The zero-moment point of a body that accelerates by a is a h / g behind its centre of mass. The
// second command is reached before the foot lands, the third one while it stands.
BOOST_FIXTURE_TEST_CASE(foot_lands_at_the_mean_zero_moment_point_of_its_stance, FootholdFixture) {
  measured.yaw = 0.0;
  body.start(measured, size.height);
  walk({0.2, 0.1, 0.0}, 1.0);
  for (const WalkVelocity& command :
       {WalkVelocity{1.0, 0.0, 0.0}, WalkVelocity{1.05, 0.0, 0.0}, WalkVelocity{0.3, -0.2, 0.0}}) {
    walk(command, 0.02);
    const Eigen::Vector2d landed = of(RR_);
    const Eigen::Vector2d if_it_lasted =
        hip(RR_, kTimeLeft + 0.5 * kStanceTime) - size.time * size.time * body.a_world();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    walk(command, kTimeLeft);
    const int ticks = std::lround(kStanceTime / kDt);
    for (int k = 0; k < ticks; ++k) {
      walk(command, kDt);
      sum += body.motion().p_com - size.time * size.time * body.a_world();
    }
    const Eigen::Vector2d planned = sum / ticks + size.nominal_feet.col(RR_).head<2>();
    BOOST_TEST((landed - planned).norm() < 2e-3);
    BOOST_TEST((landed - if_it_lasted).norm() > 0.02);
  }
}

BOOST_FIXTURE_TEST_CASE(foothold_stays_within_reach_of_the_leg, FootholdFixture) {
  measured.v_com << 30.0, -40.0;
  const Eigen::Vector2d offset = of(FR_) - hip(FR_, kTimeLeft);
  BOOST_TEST(std::abs(offset.norm() - 0.83 * size.height) < 1e-9);
  BOOST_TEST((offset.normalized() - Eigen::Vector2d(0.6, -0.8)).norm() < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
