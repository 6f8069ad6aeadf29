// SPDX-License-Identifier: BSD-3-Clause
#include "reference/three_leg_stance.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// The constants are chosen; tests/closed_loop/test_lost_leg.py covers them.
//
// The centre of mass keeps a distance from the long edge of the support triangle, which is the
// diagonal between the neighbours of the lost leg. The constant is this distance as a share of the
// triangle's inradius. If smaller: the robot tips over the long edge. If larger: the body shifts
// further, and the legs have less reach left. At 1 the centre of mass is as far from this edge as
// the incentre.
constexpr double kInradiusShare = 0.5;
// [s] Time constant of the shift. If shorter: the body jerks. If much longer: the robot falls over
// the long edge before the shift is done. The fall grows with a time constant of sqrt(h / g), 0.17
// s at h = 0.3 m, and begins slowly, because the centre of mass is near this edge.
constexpr double kShiftTime = 0.2;

}  // namespace

// In four-legged stance the centre of mass is near the diagonal between the lateral and the
// longitudinal neighbour of the lost leg. Compute the shift from there into the support triangle.
void ThreeLegStance::update(int lost_leg, const FeetMatrix& nominal_feet, const Vector3& p_com,
                            double dt) noexcept {
  if (lost_leg < 0) return;
  const Eigen::Vector2d a = nominal_feet.col(lateral_neighbor(lost_leg)).head<2>();
  const Eigen::Vector2d b = nominal_feet.col(longitudinal_neighbor(lost_leg)).head<2>();
  const Eigen::Vector2d c = nominal_feet.col(diagonal_leg(lost_leg)).head<2>();
  const Eigen::Vector2d edge = b - a;
  const double length = std::max(edge.norm(), 1e-6);
  Eigen::Vector2d inward(-edge.y() / length, edge.x() / length);
  if (inward.dot(c - a) < 0.0) inward = -inward;
  const double height = inward.dot(c - a);
  const double inradius = height * length / (length + (c - a).norm() + (c - b).norm());
  const double shortfall = kInradiusShare * inradius - inward.dot(p_com.head<2>() - a);
  const Eigen::Vector2d desired_offset = std::max(shortfall, 0.0) * inward;
  com_offset_.head<2>() += dt / (dt + kShiftTime) * (desired_offset - com_offset_.head<2>());
}

}  // namespace surefoot
