// SPDX-License-Identifier: BSD-3-Clause
#include "reference/foot_to_lift.hpp"

#include <algorithm>
#include <cmath>

#include "reference/support_polygon.hpp"

namespace surefoot {

int foot_to_lift(const FeetMatrix& p_world_feet, const std::array<bool, kLegs>& bearing,
                 const Eigen::Vector2d& capture, const Vector3& stride, double swing,
                 double gain) noexcept {
  double best = gain + std::max(0.0, SupportPolygon(p_world_feet, bearing).margin(capture));
  int found = -1;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!bearing[leg]) continue;
    std::array<bool, kLegs> others = bearing;
    others[leg] = false;
    if (std::count(others.begin(), others.end(), true) < 2) continue;
    const Eigen::Vector2d left = SupportPolygon(p_world_feet, others).beyond(capture);
    const Eigen::Vector2d then = capture + std::expm1(swing) * left;
    FeetMatrix landed = p_world_feet;
    landed.col(leg) += stride;
    const double margin = SupportPolygon(landed, bearing).margin(then);
    if (margin <= best) continue;
    best = margin;
    found = leg;
  }
  return found;
}

}  // namespace surefoot
