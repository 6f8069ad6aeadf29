// SPDX-License-Identifier: BSD-3-Clause
#include "reference/foot_to_lift.hpp"

#include <algorithm>
#include <cmath>

#include "reference/support_polygon.hpp"

namespace surefoot {

int foot_to_lift(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_goals,
                 const std::array<bool, kLegs>& loaded, const Eigen::Vector2d& capture,
                 double swing, double min_margin) noexcept {
  const SupportPolygon support(p_world_feet, loaded);
  int best_leg = -1;
  if (support.is_valid() && support.margin(capture) > 0.0) return best_leg;
  double best = min_margin;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!loaded[leg]) continue;
    std::array<bool, kLegs> remaining = loaded;
    remaining[leg] = false;
    if (std::count(remaining.begin(), remaining.end(), true) < 2) continue;
    const Eigen::Vector2d outside =
        SupportPolygon(p_world_feet, remaining).displacement_outside(capture);
    const Eigen::Vector2d capture_at_landing = capture + std::expm1(swing) * outside;
    FeetMatrix landed = p_world_feet;
    landed.col(leg) = p_world_goals.col(leg);
    const double margin = SupportPolygon(landed, loaded).margin(capture_at_landing);
    if (margin <= best) continue;
    best = margin;
    best_leg = leg;
  }
  return best_leg;
}

}  // namespace surefoot
