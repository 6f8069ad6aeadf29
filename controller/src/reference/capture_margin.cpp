// SPDX-License-Identifier: BSD-3-Clause
#include "reference/capture_margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

std::array<bool, kLegs> stance_of(const Reference& reference) noexcept {
  std::array<bool, kLegs> stance;
  for (int leg = 0; leg < kLegs; ++leg) {
    stance[leg] = reference.feet[leg].stance && reference.feet[leg].load > 0.0;
  }
  return stance;
}

}  // namespace

Eigen::Vector2d capture_point(const Dynamics& dynamics, const Vector3& dv_com) noexcept {
  const double ground = contact_points(dynamics).row(2).mean();
  // [m] Avoids a division by zero. Chosen: less than the height of any lying robot.
  const double height = std::max(dynamics.p_world_com().z() - ground, 0.05);
  const double omega = std::sqrt(kGravity / height);
  return (dynamics.p_world_com() + (dynamics.v_world_com() + dv_com) / omega).head<2>();
}

SupportPolygon support_polygon(const Dynamics& dynamics, const Reference& reference) noexcept {
  return SupportPolygon(contact_points(dynamics), stance_of(reference));
}

double capture_margin(const Dynamics& dynamics, const Reference& reference,
                      const Vector3& dv_com) noexcept {
  if (reference.stepping) return std::numeric_limits<double>::infinity();
  return capture_margin(dynamics, stance_of(reference), dv_com);
}

double capture_margin(const Dynamics& dynamics, const std::array<bool, kLegs>& stance,
                      const Vector3& dv_com) noexcept {
  // Fewer than three stance feet span no polygon. The result is then +inf: no margin is defined.
  // The 0 of SupportPolygon::margin() would mean that the capture point is at an edge.
  const SupportPolygon polygon(contact_points(dynamics), stance);
  return polygon.is_valid() ? polygon.margin(capture_point(dynamics, dv_com))
                            : std::numeric_limits<double>::infinity();
}

}  // namespace surefoot
