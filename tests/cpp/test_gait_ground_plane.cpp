// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "gait/ground_plane.hpp"

using namespace surefoot;

namespace {

const double kSlope = std::tan(15.0 * M_PI / 180.0);

struct PlaneFixture {
  GroundPlane ground;
  FeetMatrix feet;  // FR FL RR RL, level, at height 0.1
  PlaneFixture() {
    feet << 0.2, 0.2, -0.2, -0.2, -0.13, 0.13, -0.13, 0.13, 0.1, 0.1, 0.1, 0.1;
    ground.start(feet, Eigen::Vector4d::Ones(), Vector3::UnitZ());
  }
  void stand(const FeetMatrix& points) {
    for (int leg = 0; leg < kLegs; ++leg) ground.stand_at(leg, points.col(leg));
  }
  void run(double seconds) {
    for (int k = 0; k < seconds / 0.002; ++k) ground.update(0.1, {0.0, 0.0}, 0.0, 0.002);
  }
  Vector3 sloping() const { return Vector3(-kSlope, 0.0, 1.0).normalized(); }
  FeetMatrix sloped() const {
    FeetMatrix points = feet;
    points.row(2) += kSlope * points.row(0);
    return points;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_ground_plane)

BOOST_FIXTURE_TEST_CASE(level_ground_has_a_vertical_normal, PlaneFixture) {
  BOOST_TEST((ground.normal() - Vector3::UnitZ()).norm() < 1e-12);
  BOOST_TEST(std::abs(ground.height_at({3.0, -2.0}) - 0.1) < 1e-12);
}

BOOST_FIXTURE_TEST_CASE(slope_of_15_degrees_is_found_at_the_start, PlaneFixture) {
  ground.start(sloped(), Eigen::Vector4d::Ones(), sloping());
  BOOST_TEST((ground.normal() - Vector3(-kSlope, 0.0, 1.0).normalized()).norm() < 1e-12);
  BOOST_TEST(std::abs(ground.height_at({1.0, 0.5}) - 0.1 - kSlope) < 1e-12);
}

// A robot that is pushed steps when it already tips over two feet.
BOOST_FIXTURE_TEST_CASE(feet_in_the_air_are_over_the_ground_at_the_start, PlaneFixture) {
  FeetMatrix tipped = sloped();
  tipped(2, FR_) += 0.05;
  tipped(2, RR_) += 0.08;
  ground.start(tipped, {0.0, 1.0, 0.0, 1.0}, sloping());
  run(1.0);
  BOOST_TEST((ground.normal() - sloping()).norm() < 1e-3);
  BOOST_TEST(std::abs(ground.height_at({0.2, 0.0}) - 0.1 - 0.2 * kSlope) < 1e-3);
}

BOOST_FIXTURE_TEST_CASE(normal_approaches_a_new_slope_within_its_time_constant, PlaneFixture) {
  stand(sloped());
  BOOST_TEST((ground.normal() - Vector3::UnitZ()).norm() < 1e-12);  // only update() moves it
  run(0.2);
  const double share = (ground.normal() - sloping()).norm() / (Vector3::UnitZ() - sloping()).norm();
  BOOST_TEST(std::abs(share - std::exp(-1.0)) < 0.02);
  run(3.0);
  BOOST_TEST((ground.normal() - sloping()).norm() < 1e-5);
  BOOST_TEST(std::abs(ground.normal().norm() - 1.0) < 1e-12);
}

// The plane is parallel to both diagonals, so a raised foot tilts it by half its height.
BOOST_FIXTURE_TEST_CASE(foot_on_a_step_tilts_the_plane_by_half_the_step, PlaneFixture) {
  feet(2, FR_) += 0.06;
  stand(feet);
  run(3.0);
  const double front = ground.height_at({0.2, 0.0}), rear = ground.height_at({-0.2, 0.0});
  BOOST_TEST(std::abs(front - rear - 0.03) < 1e-3);
  BOOST_TEST(std::abs(ground.height_at({0.0, 0.0}) - 0.1 - 0.015) < 1e-9);
}

// The body is not jerked when a foot lands on a step.
BOOST_FIXTURE_TEST_CASE(height_for_the_body_approaches_a_step_without_a_jump, PlaneFixture) {
  feet(2, FR_) += 0.08;
  stand(feet);
  run(0.002);
  BOOST_TEST(std::abs(ground.height_at({0.0, 0.0}) - 0.1 - 0.02) < 1e-6);
  BOOST_TEST(std::abs(ground.height_of_soles({0.0, 0.0}) - 0.1) < 1e-3);
  run(0.1);
  BOOST_TEST(std::abs(ground.height_of_soles({0.0, 0.0}) - 0.1 - 0.02 * (1.0 - std::exp(-1.0))) <
             1e-3);
}

BOOST_FIXTURE_TEST_CASE(height_for_the_body_does_not_lag_on_a_slope, PlaneFixture) {
  ground.start(sloped(), Eigen::Vector4d::Ones(), sloping());
  Eigen::Vector2d body(0.0, 0.0);
  for (int k = 0; k < 1000; ++k) {
    body.x() += 0.002 * 0.5;  // 0.5 m/s; the feet follow in every tick
    FeetMatrix points = feet;
    points.row(0).array() += body.x();
    points.row(2) += kSlope * points.row(0);
    stand(points);
    ground.update(0.1, body, 0.0, 0.002);
    BOOST_REQUIRE(std::abs(ground.height_of_soles(body) - 0.1 - kSlope * body.x()) < 1e-9);
  }
}

BOOST_FIXTURE_TEST_CASE(feet_that_span_no_ground_keep_the_normal, PlaneFixture) {
  ground.start(sloped(), Eigen::Vector4d::Ones(), sloping());
  const Vector3 before = ground.normal();
  FeetMatrix in_line = feet;
  in_line.row(1) *= 1e-4;
  in_line.row(2) += in_line.row(1);  // a plane that leans by 45 degrees
  FeetMatrix wall = feet;            // the left feet are 0.6 m above the right feet: 67 degrees
  wall.row(2) += 2.3 * wall.row(1);
  FeetMatrix crossed = feet;  // left and right exchanged: the normal would point down
  crossed.row(1) *= -1.0;
  for (const FeetMatrix& points : {in_line, wall, crossed}) {
    stand(points);
    run(1.0);
    BOOST_TEST((ground.normal() - before).norm() < 1e-12);
  }
}

BOOST_FIXTURE_TEST_CASE(body_follows_the_sink_of_the_soles_and_footholds_do_not, PlaneFixture) {
  ground.start(feet, Eigen::Vector4d::Ones(), Vector3::UnitZ());
  const double height = ground.height_at({0.0, 0.0});
  for (int k = 0; k < 1000; ++k) ground.update(0.1, {0.0, 0.0}, 0.005, 0.002);
  BOOST_TEST(std::abs(ground.height_at({0.0, 0.0}) - height) < 1e-9);
  BOOST_TEST(std::abs(ground.height_of_soles({0.0, 0.0}) - height + 0.005) < 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
