// SPDX-License-Identifier: BSD-3-Clause
#include "reference/three_leg_stance.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// Distance to keep from the long edge, as a share of the triangle's inradius.
constexpr double kInradiusShare = 0.5;
constexpr double kShiftTime = 0.2;  // [s] time constant of the shift

}  // namespace

// The body stands near the edge between the lateral and the longitudinal neighbour of the lost leg.
void ThreeLegStance::update(const FeetMatrix& nominal_feet, const Vector3& p_com,
                            double dt) noexcept {
  if (lost_leg_ == kNone) return;
  const Eigen::Vector2d a = nominal_feet.col(lateral_neighbor(lost_leg_)).head<2>();
  const Eigen::Vector2d b = nominal_feet.col(longitudinal_neighbor(lost_leg_)).head<2>();
  const Eigen::Vector2d c = nominal_feet.col(diagonal_leg(lost_leg_)).head<2>();
  const Eigen::Vector2d edge = b - a;
  const double length = std::max(edge.norm(), 1e-6);
  Eigen::Vector2d inward(-edge.y() / length, edge.x() / length);
  if (inward.dot(c - a) < 0.0) inward = -inward;
  const double height = inward.dot(c - a);
  const double inradius = height * length / (length + (c - a).norm() + (c - b).norm());
  const double shortfall = kInradiusShare * inradius - inward.dot(p_com.head<2>() - a);
  const Eigen::Vector2d desired = std::max(shortfall, 0.0) * inward;
  com_offset_.head<2>() += dt / (dt + kShiftTime) * (desired - com_offset_.head<2>());
}

}  // namespace surefoot
