// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "capture_point_robot.hpp"
#include "reference/capture_margin.hpp"
#include "reference/usable_friction.hpp"

using namespace surefoot;

namespace {

constexpr double kNominalShare = 0.7, kEdgeDistance = 0.06;

struct UsableFrictionFixture : CapturePointRobot {
  // Return the steady-state share of friction.
  Eigen::Vector4d share() {
    UsableFriction friction;
    friction.update(dynamics, state, reference, robot.mass(), 1.0, 1.0);
    return friction.update(dynamics, state, reference, robot.mass(), 1.0, 1.0);
  }
  // Move the capture point to `margin` [m] inside the left edge.
  void lean_to(double margin) {
    const double edge = contact_points(robot, state.q)(1, FL_);
    set_com_velocity(Vector3(0.0, (edge - margin - dynamics.p_world_com().y()) * omega(), 0.0));
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(friction_in_use)

BOOST_FIXTURE_TEST_CASE(friction_share_rises_from_0_7_to_1_at_the_edge, UsableFrictionFixture) {
  BOOST_TEST((share().array() - kNominalShare).abs().maxCoeff() < 1e-12);
  for (const double margin : {0.1, kEdgeDistance, 0.03, 0.0, -0.05}) {
    lean_to(margin);
    const double calm = std::min(std::max(margin / kEdgeDistance, 0.0), 1.0);
    BOOST_TEST((share().array() - (1.0 - calm * (1.0 - kNominalShare))).abs().maxCoeff() < 1e-9);
  }
}

// A push that will move the capture point to the edge raises the share before the body moves.
BOOST_FIXTURE_TEST_CASE(predicted_push_displacement_raises_the_friction_share,
                        UsableFrictionFixture) {
  const double inside = capture_margin(dynamics, reference);
  const double enough = inside * omega() * robot.mass() / 0.1;  // [N] for 0.1 s
  state.f_external.y() = 0.2 * enough;
  BOOST_TEST((share().array() - kNominalShare).abs().maxCoeff() < 1e-12);
  state.f_external.y() = enough;
  BOOST_TEST((share().array() - 1.0).abs().maxCoeff() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(slipping_feet_use_their_reduced_friction, UsableFrictionFixture) {
  state.friction << 1.0, 0.5, 0.0, 1.0;
  BOOST_TEST(
      (share() - Eigen::Vector4d(kNominalShare, 0.5, 0.0, kNominalShare)).cwiseAbs().maxCoeff() <
      1e-12);
}

// The end of a push looks like a push in the opposite direction.
BOOST_FIXTURE_TEST_CASE(inward_push_does_not_reduce_the_friction_share, UsableFrictionFixture) {
  lean_to(0.0);
  state.f_external.y() = -20.0 * robot.mass();
  BOOST_TEST((share().array() - 1.0).abs().maxCoeff() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(two_loaded_feet_use_full_friction, UsableFrictionFixture) {
  reference.feet[FR_].load = reference.feet[RL_].load = 0.0;
  BOOST_TEST((share().array() - 1.0).abs().maxCoeff() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(friction_share_rises_at_once_and_falls_within_100_ms,
                        UsableFrictionFixture) {
  UsableFriction friction;
  const auto tick = [&] {
    return friction.update(dynamics, state, reference, robot.mass(), 1.0, 0.002)[0];
  };
  for (int k = 1; k <= 60; ++k)
    BOOST_TEST(std::abs(tick() - std::max(1.0 - 0.006 * k, kNominalShare)) < 1e-9);
  lean_to(0.0);
  BOOST_TEST(std::abs(tick() - 1.0) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
