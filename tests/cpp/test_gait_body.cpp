// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "walking_body.hpp"

using namespace surefoot;

namespace {

struct BodyFixture : WalkingBody {
  BodySway sway{size};
  BodyMotion offset{quadruped()};
  FeetMatrix feet;  // around the measured body, at height 0
  BodyFixture() {
    feet = size.nominal_feet;
    feet.topRows<2>().colwise() += measured.p_com;
    feet.row(2).setZero();
    const Eigen::VectorXd q = quadruped().q_standing();
    offset.latch({Vector3(0.0, 0.0, size.height), Quaternion::Identity()},
                 Vector3(0.0, 0.0, size.height), q);
  }
  const Reference& written(double ahead = 0.0, const Vector3& normal = Vector3::UnitZ()) {
    GroundPlane ground;
    ground.start(feet, Eigen::Vector4d::Ones(), normal);
    body.write(ground, sway, offset, ahead, reference);
    return reference;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_body)

BOOST_FIXTURE_TEST_CASE(body_starts_at_rest_where_it_is, BodyFixture) {
  const Vector3 p(measured.p_com.x(), measured.p_com.y(), size.height);
  BOOST_TEST((written().p_com - p).norm() < 1e-12);
  BOOST_TEST((reference.v_com.norm() + reference.a_com.norm() + reference.w_world_base.norm()) ==
             0.0);
  BOOST_TEST(reference.R_world_base.angularDistance(exp_so3(0.4 * Vector3::UnitZ())) < 1e-7);
}

BOOST_FIXTURE_TEST_CASE(velocity_approaches_the_command_with_limited_acceleration, BodyFixture) {
  const WalkVelocity command{0.6, -0.3, 0.0};
  const double limit = gains.walk_acceleration * kGravity;
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  for (int k = 0; k < 500; ++k) {
    tick(command);
    const Eigen::Vector2d now(body.velocity().vx, body.velocity().vy);
    BOOST_REQUIRE((now - last).norm() < kDt * limit + 1e-12);
    BOOST_REQUIRE(std::abs(body.a_world().norm() - (now - last).norm() / kDt) < 1e-9);
    last = now;
    if (k == 99) BOOST_TEST(std::abs(now.norm() - 100 * kDt * limit) < 1e-9);
  }
  BOOST_TEST((last - Eigen::Vector2d(0.6, -0.3)).norm() == 0.0);
  BOOST_TEST((body.v_world() - Eigen::Rotation2Dd(0.4) * last).norm() < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(yaw_rate_approaches_the_command_with_limited_acceleration, BodyFixture) {
  const double limit = gains.walk_turn_acceleration * kGravity / size.height;
  walk({0.0, 0.0, -1.0}, 0.05);
  BOOST_TEST(std::abs(body.velocity().yaw_rate + 0.05 * limit) < 1e-9);
  walk({0.0, 0.0, -1.0}, 1.0);
  BOOST_TEST(body.velocity().yaw_rate == -1.0);
}

// A turning body that goes forward accelerates sideways.
BOOST_FIXTURE_TEST_CASE(turning_walk_has_centripetal_acceleration, BodyFixture) {
  walk({0.5, 0.0, 1.0}, 2.0);
  const Eigen::Vector2d to_the_left(-std::sin(body.yaw()), std::cos(body.yaw()));
  BOOST_TEST((body.a_world() - 0.5 * to_the_left).norm() < 2e-3);
}

BOOST_FIXTURE_TEST_CASE(position_stays_near_a_body_that_is_held, BodyFixture) {
  for (int k = 0; k < 2000; ++k) body.update(gains, {0.5, 0.0, 0.0}, measured, 1.0, kDt);
  const Eigen::Vector2d ahead = written().p_com.head<2>() - measured.p_com;
  BOOST_TEST(std::abs(ahead.norm() - 0.17 * size.height) < 1e-9);
  BOOST_TEST(std::abs(ahead.norm() - ahead.dot(Eigen::Vector2d(std::cos(0.4), std::sin(0.4)))) <
             1e-9);
}

BOOST_FIXTURE_TEST_CASE(heading_stays_near_the_body_through_full_turns, BodyFixture) {
  measured.yaw = M_PI - 0.05;
  body.start(measured, size.height);
  for (int k = 0; k < 5000; ++k) {
    body.update(gains, {0.0, 0.0, 1.0}, measured, 1.0, kDt);
    const Quaternion heading = exp_so3(measured.yaw * Vector3::UnitZ());
    BOOST_REQUIRE(written().R_world_base.angularDistance(heading) < 0.1 + 1e-6);
    measured.yaw = std::remainder(measured.yaw + 0.9 * kDt, 2.0 * M_PI);  // slower: it lags
  }
  const Quaternion heading = exp_so3((measured.yaw - 0.9 * kDt) * Vector3::UnitZ());
  BOOST_TEST(std::abs(reference.R_world_base.angularDistance(heading) - 0.1) < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(heading_of_a_body_that_follows_is_continuous_at_half_turns, BodyFixture) {
  for (int k = 0; k < 5000; ++k) {
    const double last = body.yaw();
    tick({0.0, 0.0, 1.5});
    const double turned = std::remainder(body.yaw() - last, 2.0 * M_PI);
    BOOST_REQUIRE(std::abs(turned - kDt * body.velocity().yaw_rate) < 1e-9);
  }
}

BOOST_FIXTURE_TEST_CASE(body_follows_a_slope_at_the_standing_height, BodyFixture) {
  const double rise = std::tan(15.0 * M_PI / 180.0);
  measured.yaw = 0.0;
  body.start(measured, size.height);
  walk({0.4, 0.0, 0.5}, 1.0);
  feet.row(2) = rise * feet.row(0);
  const Vector3 normal = Vector3(-rise, 0.0, 1.0).normalized();
  written(0.0, normal);
  BOOST_TEST((reference.ground_normal - normal).norm() < 1e-9);
  BOOST_TEST(std::abs(reference.p_com.z() - rise * reference.p_com.x() - size.height) < 1e-9);
  BOOST_TEST(std::abs(reference.v_com.z() - rise * reference.v_com.x()) < 1e-9);
  BOOST_TEST(std::abs(reference.a_com.z() - rise * reference.a_com.x()) < 1e-9);
  BOOST_TEST((reference.R_world_base * Vector3::UnitZ() - normal).norm() < 1e-9);
  BOOST_TEST((reference.w_world_base - 0.5 * normal).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(body_rises_to_its_standing_height, BodyFixture) {
  body.start(measured, size.height - 0.05);
  walk({}, 0.2);
  BOOST_TEST(std::abs(size.height - written().p_com.z() - 0.05 * std::exp(-1.0)) < 1e-3);
  walk({}, 1.5);
  BOOST_TEST(std::abs(size.height - written().p_com.z()) < 1e-4);
}

// The offset moves at limited speed, and so does the reference.
BOOST_FIXTURE_TEST_CASE(body_has_the_requested_height_and_attitude_over_its_heading, BodyFixture) {
  FeetMatrix stance = size.nominal_feet;
  stance.row(2).setZero();
  offset.set_walking(true);
  offset.set_target({0.05, 0.05, -0.02, 0.05, 0.1, 0.3});
  double last = 0.0;
  for (int k = 0; k < 1000; ++k) {
    offset.update(gains, stance, -Vector3::UnitZ(), kDt);
    const double z = written().p_com.z();
    BOOST_REQUIRE((k == 0 || std::abs(z - last) <= gains.reference_speed * kDt + 1e-9));
    last = z;
  }
  BOOST_TEST(std::abs(last - size.height + 0.02) < 1e-4);
  BOOST_TEST((reference.p_com.head<2>() - measured.p_com).norm() < 1e-9);
  const Quaternion R = exp_so3(0.4 * Vector3::UnitZ()) * exp_so3(0.1 * Vector3::UnitY()) *
                       exp_so3(0.05 * Vector3::UnitX());
  BOOST_TEST(reference.R_world_base.angularDistance(R) < 1e-3);
}

BOOST_FIXTURE_TEST_CASE(reference_is_written_for_the_time_when_the_command_acts, BodyFixture) {
  walk({0.5, 0.1, 0.8}, 1.0);
  const Reference now = written();
  const Reference later = written(0.02);
  BOOST_TEST((later.p_com - now.p_com - 0.02 * now.v_com).norm() < 1e-12);
  BOOST_TEST(std::abs(later.R_world_base.angularDistance(now.R_world_base) - 0.016) < 1e-7);
}

BOOST_AUTO_TEST_SUITE_END()
