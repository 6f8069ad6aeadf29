// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_polygon.hpp"

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {

// Legs in counter-clockwise order, seen from above.
constexpr int kCounterClockwise[kLegs] = {FR_, FL_, RL_, RR_};

}  // namespace

SupportPolygon::SupportPolygon(const FeetMatrix& feet,
                               const std::array<bool, kLegs>& stance) noexcept {
  for (const int leg : kCounterClockwise) {
    if (stance[leg]) corners_[count_++] = feet.col(leg).head<2>();
  }
}

SupportPolygon::Edge SupportPolygon::edge(int k, const Eigen::Vector2d& point) const noexcept {
  const Eigen::Vector2d along = corners_[(k + 1) % count_] - corners_[k];
  const Eigen::Vector2d outward =
      Eigen::Vector2d(along.y(), -along.x()) / std::max(along.norm(), 1e-6);
  return {outward, outward.dot(corners_[k] - point)};
}

double SupportPolygon::margin(const Eigen::Vector2d& point) const noexcept {
  if (!is_valid()) return 0.0;
  double margin = std::numeric_limits<double>::infinity();
  for (int k = 0; k < count_; ++k) margin = std::min(margin, edge(k, point).margin);
  return margin;
}

}  // namespace surefoot
