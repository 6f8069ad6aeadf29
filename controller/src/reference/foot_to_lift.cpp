// SPDX-License-Identifier: BSD-3-Clause
#include "reference/foot_to_lift.hpp"

#include <algorithm>
#include <cmath>

#include "reference/support_polygon.hpp"

namespace surefoot {

int foot_to_lift(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_goals,
                 const std::array<bool, kLegs>& bearing, const Eigen::Vector2d& capture,
                 double swing, double gain) noexcept {
  const SupportPolygon support(p_world_feet, bearing);
  int found = -1;
  if (support.exists() && support.margin(capture) > 0.0) return found;
  double best = gain;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!bearing[leg]) continue;
    std::array<bool, kLegs> others = bearing;
    others[leg] = false;
    if (std::count(others.begin(), others.end(), true) < 2) continue;
    const Eigen::Vector2d left = SupportPolygon(p_world_feet, others).beyond(capture);
    const Eigen::Vector2d then = capture + std::expm1(swing) * left;
    FeetMatrix landed = p_world_feet;
    landed.col(leg) = p_world_goals.col(leg);
    const double margin = SupportPolygon(landed, bearing).margin(then);
    if (margin <= best) continue;
    best = margin;
    found = leg;
  }
  return found;
}

}  // namespace surefoot
