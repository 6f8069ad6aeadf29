// SPDX-License-Identifier: BSD-3-Clause
#include "reference/capture_margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/support_polygon.hpp"

namespace surefoot {

double capture_margin(const Dynamics& dynamics, const Reference& reference,
                      const Vector3& gained) noexcept {
  std::array<bool, kLegs> stance;
  for (int leg = 0; leg < kLegs; ++leg) {
    stance[leg] = reference.feet[leg].stance && reference.feet[leg].load > 0.0;
  }
  return capture_margin(dynamics, stance, gained);
}

double capture_margin(const Dynamics& dynamics, const std::array<bool, kLegs>& stance,
                      const Vector3& gained) noexcept {
  FeetMatrix feet;
  for (int leg = 0; leg < kLegs; ++leg) feet.col(leg) = dynamics.legs()[leg].p_world_contact;
  const double height = std::max(dynamics.p_world_com().z() - feet.row(2).mean(), 0.05);
  const double omega = std::sqrt(kGravity / height);
  const Vector3 capture = dynamics.p_world_com() + (dynamics.v_world_com() + gained) / omega;
  // Fewer than three feet have no edge to be near.
  const SupportPolygon polygon(feet, stance);
  return polygon.exists() ? polygon.margin(capture.head<2>())
                          : std::numeric_limits<double>::infinity();
}

}  // namespace surefoot
