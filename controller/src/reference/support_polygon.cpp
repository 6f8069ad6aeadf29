// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_polygon.hpp"

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {

// Round the robot, counter-clockwise from above.
constexpr int kRound[kLegs] = {FR_, FL_, RL_, RR_};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

SupportPolygon::SupportPolygon(const FeetMatrix& feet,
                               const std::array<bool, kLegs>& stance) noexcept {
  for (const int leg : kRound) {
    if (stance[leg]) corners_[count_++] = feet.col(leg).head<2>();
  }
}

double SupportPolygon::margin(const Eigen::Vector2d& point) const noexcept {
  if (!exists()) return 0.0;
  double margin = std::numeric_limits<double>::infinity();
  for (int k = 0; k < count_; ++k) {
    const Eigen::Vector2d edge = corners_[(k + 1) % count_] - corners_[k];
    margin = std::min(margin, cross(edge, point - corners_[k]) / std::max(edge.norm(), 1e-6));
  }
  return margin;
}

}  // namespace surefoot
