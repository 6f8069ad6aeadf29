// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <limits>

#include "gait/body_sway.hpp"
#include "quadruped.hpp"
#include "reference/support_polygon.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002, kPeriod = 0.9, kSwing = 0.18;  // [s]
constexpr int kOrder[kLegs] = {RR_, FR_, RL_, FL_};

// A robot that walks on the spot: leg kOrder[k] swings from k kPeriod / 4 on.
struct SwayFixture {
  GaitSize size{quadruped()};
  BodySway sway{size};
  double margin = 0.17 * size.height, time = 0.0;
  bool walks = true;
  BodySway::Input input{Eigen::Vector2d::Zero(),
                        Eigen::Vector2d::Zero(),
                        Eigen::Vector2d::Zero(),
                        {},
                        {},
                        0.25 * kPeriod - kSwing,
                        margin,
                        {}};

  void tick() {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kLegs; ++k) {
      const int leg = kOrder[k];
      const Eigen::Vector2d p = size.nominal_feet.col(leg).head<2>();
      const double since = std::fmod(time - 0.25 * k * kPeriod + kPeriod, kPeriod);
      input.stance[leg] = !walks || since >= kSwing;
      input.swings[leg] = since < kSwing ? NextSwing{0.0, kSwing - since, 0.0, p, p}
                                         : NextSwing{kPeriod - since, kPeriod - since + kSwing,
                                                     since - kSwing, p, p};
      if (!walks) input.swings[leg] = {kNever, kNever, kNever, p, p};
    }
    sway.update(input, kDt);
    time += kDt;
  }
  void run(double seconds) {
    for (int k = 0; k < seconds / kDt - 0.5; ++k) tick();
  }
  double zmp_margin() const {
    FeetMatrix feet = size.nominal_feet;
    const Eigen::Vector2d zmp = sway.p() - size.time * size.time * sway.a();
    return SupportPolygon(feet, input.stance).margin(zmp);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_sway)

BOOST_FIXTURE_TEST_CASE(zero_moment_point_is_inside_every_support_triangle, SwayFixture) {
  run(2.0 * kPeriod);
  double least = 1.0, largest = 0.0;
  for (int k = 0; k < 3.0 * kPeriod / kDt; ++k) {
    tick();
    least = std::min(least, zmp_margin());
    largest = std::max(largest, sway.p().norm());
  }
  BOOST_TEST(least > 0.9 * margin);
  BOOST_TEST(largest < margin);  // the centre of mass moves less than the zero-moment point
  BOOST_TEST(largest > 0.1 * margin);
}

// Right feet swing in the first half of the period.
BOOST_FIXTURE_TEST_CASE(body_sways_away_from_the_feet_that_swing, SwayFixture) {
  run(2.0 * kPeriod);
  double left = 0.0, right = 0.0;
  for (int k = 0; k < kPeriod / kDt; ++k) {
    tick();
    (k < 0.5 * kPeriod / kDt ? right : left) += sway.p().y();
  }
  BOOST_TEST(right > 0.0);
  BOOST_TEST(left < 0.0);
}

BOOST_FIXTURE_TEST_CASE(sway_ends_without_a_jump_when_no_foot_swings_any_more, SwayFixture) {
  run(2.3 * kPeriod);
  walks = false;
  Eigen::Vector2d last = sway.v();
  const double most = kGravity / size.height * 0.5 * size.nominal_feet.norm();
  for (int k = 0; k < 500; ++k) {
    tick();
    BOOST_REQUIRE((sway.v() - last).norm() < most * kDt);
    last = sway.v();
  }
  BOOST_TEST(sway.is_at_rest());
  BOOST_TEST(sway.p().norm() < 1e-3);
}

BOOST_FIXTURE_TEST_CASE(trot_does_not_sway, SwayFixture) {
  walks = false;
  run(0.5);
  BOOST_TEST(sway.p().norm() == 0.0);
}

// The zero-moment point of a body that accelerates is behind it.
BOOST_FIXTURE_TEST_CASE(acceleration_of_the_body_counts, SwayFixture) {
  input.a = Eigen::Vector2d(1.0, 0.0);
  run(3.0 * kPeriod);
  const Eigen::Vector2d a = sway.a() + input.a;
  const Eigen::Vector2d zmp = sway.p() - size.time * size.time * a;
  BOOST_TEST(SupportPolygon(size.nominal_feet, input.stance).margin(zmp) > 0.9 * margin);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(support_polygon)

BOOST_AUTO_TEST_CASE(nearest_inside_keeps_the_margin_and_is_the_nearest_of_many_points) {
  const FeetMatrix feet = GaitSize(quadruped()).nominal_feet;
  for (int swing = -1; swing < kLegs; ++swing) {
    std::array<bool, kLegs> stance = {true, true, true, true};
    if (swing >= 0) stance[swing] = false;
    const SupportPolygon polygon(feet, stance);
    for (int k = 0; k < 24; ++k) {
      const Eigen::Vector2d p = 0.01 * k * Eigen::Vector2d(std::cos(2.0 * k), std::sin(2.0 * k));
      const Eigen::Vector2d nearest = polygon.nearest_inside(p, 0.03);
      BOOST_REQUIRE(polygon.margin(nearest) > 0.03 - 1e-9);
      for (double x = -0.2; x <= 0.2; x += 0.01) {
        for (double y = -0.2; y <= 0.2; y += 0.01) {
          const Eigen::Vector2d other(x, y);
          if (polygon.margin(other) < 0.03) continue;
          BOOST_REQUIRE((nearest - p).norm() < (other - p).norm() + 1e-9);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(nearest_inside_of_a_narrow_triangle_takes_a_smaller_margin) {
  FeetMatrix feet = FeetMatrix::Zero();
  feet.row(0) << 0.2, 0.2, -0.2, -0.2;
  feet.row(1) << -0.01, 0.01, -0.01, 0.01;
  const SupportPolygon polygon(feet, {true, true, true, true});
  const Eigen::Vector2d nearest = polygon.nearest_inside({0.0, 0.3}, 0.03);
  BOOST_TEST(polygon.margin(nearest) > 0.005);
  BOOST_TEST(polygon.margin(nearest) < 0.01);
}

BOOST_AUTO_TEST_SUITE_END()
