// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "reference/foot_to_lift.hpp"
#include "reference/support_polygon.hpp"

using namespace surefoot;
using Eigen::Vector2d;

namespace {

constexpr double kSwing = 0.6;
constexpr double kGain = 0.003;
constexpr std::array<bool, kLegs> kAllStance = {true, true, true, true};
constexpr std::array<bool, kLegs> kHindLeftUp = {true, true, true, false};

// Feet FR FL RR RL, 0.4 m by 0.3 m.
FeetMatrix rectangle() {
  FeetMatrix feet = FeetMatrix::Zero();
  feet.row(0) << 0.2, 0.2, -0.2, -0.2;
  feet.row(1) << -0.15, 0.15, -0.15, 0.15;
  return feet;
}

FeetMatrix shifted_rectangle(double x, double y) {
  return rectangle().colwise() + Vector3(x, y, 0.0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(foot_to_lift_)

BOOST_AUTO_TEST_CASE(outside_vector_starts_at_the_nearest_edge_corner_or_line) {
  const SupportPolygon all(rectangle(), kAllStance);
  BOOST_TEST(all.displacement_outside({0.1, 0.1}).isZero());
  BOOST_TEST(all.displacement_outside({0.25, 0.1}).isApprox(Vector2d(0.05, 0.0)));
  BOOST_TEST(all.displacement_outside({0.25, 0.2}).isApprox(Vector2d(0.05, 0.05)));
  const SupportPolygon left(rectangle(), {false, true, false, true});
  BOOST_TEST(left.displacement_outside({0.1, 0.05}).isApprox(Vector2d(0.0, -0.1)));
  BOOST_TEST(left.displacement_outside({0.1, 0.15}).isZero());
  BOOST_TEST(SupportPolygon(rectangle(), {true, false, false, false})
                 .displacement_outside({1.0, 1.0})
                 .isZero());
}

// The capture point is outside the right edge, in front of the centre: the front right foot must
// stay.
BOOST_AUTO_TEST_CASE(foot_that_lands_further_out_is_lifted) {
  const Vector2d capture(0.1, -0.16);
  BOOST_TEST(foot_to_lift(rectangle(), shifted_rectangle(0.0, -0.25), kAllStance, capture, kSwing,
                          kGain) == RR_);
}

BOOST_AUTO_TEST_CASE(foot_that_would_land_too_late_is_not_lifted) {
  const Vector2d capture(0.2, 0.0);
  // Without one front foot the capture point diverges from the other feet further than a step
  // reaches.
  BOOST_TEST(foot_to_lift(rectangle(), shifted_rectangle(0.05, 0.0), kAllStance, capture, kSwing,
                          kGain) == -1);
}

BOOST_AUTO_TEST_CASE(no_foot_is_lifted_when_a_step_does_not_help) {
  const FeetMatrix feet = rectangle();
  BOOST_TEST(foot_to_lift(feet, feet, kAllStance, {0.1, -0.16}, kSwing, kGain) == -1);
  // Still inside the support, although the step would move the edge further out.
  BOOST_TEST(foot_to_lift(feet, shifted_rectangle(0.0, -0.3), kAllStance, {0.1, -0.149}, kSwing,
                          kGain) == -1);
}

// The rear left leg is in the air; the front left foot can still step.
BOOST_AUTO_TEST_CASE(foot_is_lifted_when_two_stance_feet_remain) {
  const FeetMatrix feet = rectangle();
  const Vector2d capture(0.205, -0.1);
  const FeetMatrix goals = shifted_rectangle(0.2, 0.0);
  BOOST_TEST(foot_to_lift(feet, goals, kHindLeftUp, capture, kSwing, kGain) == FL_);
  const std::array<bool, kLegs> front = {true, true, false, false};
  BOOST_TEST(foot_to_lift(feet, goals, front, capture, kSwing, kGain) == -1);
}

BOOST_AUTO_TEST_SUITE_END()
