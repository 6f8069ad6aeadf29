// SPDX-License-Identifier: BSD-3-Clause
#include "reference/support_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

// Legs in counter-clockwise order, seen from above.
constexpr int kCounterClockwise[kLegs] = {FR_, FL_, RL_, RR_};
// nearest_inside(): number of margins that are tried. Numerical: after five halvings the rest is
// millimetres.
constexpr int kHalvings = 6;
constexpr double kTolerance = 1e-9;  // [m] numerical

}  // namespace

SupportPolygon::SupportPolygon(const FeetMatrix& feet,
                               const std::array<bool, kLegs>& stance) noexcept {
  for (const int leg : kCounterClockwise) {
    if (stance[leg]) corners_[count_++] = feet.col(leg).head<2>();
  }
  for (int k = 0; k < count_; ++k) {
    const Eigen::Vector2d along = corners_[after(k)] - corners_[k];
    outward_[k] = Eigen::Vector2d(along.y(), -along.x()) / std::max(along.norm(), 1e-6);
  }
}

double SupportPolygon::margin(const Eigen::Vector2d& point) const noexcept {
  if (!is_valid()) return 0.0;
  double margin = std::numeric_limits<double>::infinity();
  for (int k = 0; k < count_; ++k) margin = std::min(margin, edge(k, point).margin);
  return margin;
}

// Return the corner k of the polygon whose edges are moved inwards by `margin`.
Eigen::Vector2d SupportPolygon::inset_corner(int k, double margin) const noexcept {
  const Eigen::Vector2d &a = outward_[before(k)], &b = outward_[k];
  // Both edges keep the margin: a . d = b . d = -margin.
  return corners_[k] - margin / std::max(1.0 + a.dot(b), 1e-3) * (a + b);
}

Eigen::Vector2d SupportPolygon::nearest_inside(const Eigen::Vector2d& point,
                                               double margin) const noexcept {
  if (!is_valid() || this->margin(point) >= margin) return point;
  for (int halving = 0; halving < kHalvings; ++halving, margin *= 0.5) {
    double min_distance = std::numeric_limits<double>::infinity();
    Eigen::Vector2d nearest = point;
    std::array<Eigen::Vector2d, kLegs> inset;
    for (int k = 0; k < count_; ++k) inset[k] = inset_corner(k, margin);
    for (int k = 0; k < count_; ++k) {
      // The nearest point of an edge of the inset polygon, which is a side of that polygon only if
      // its ends keep the margin too.
      const Eigen::Vector2d& from = inset[k];
      const Eigen::Vector2d along = inset[after(k)] - from;
      const double share = (point - from).dot(along) / std::max(along.squaredNorm(), 1e-12);
      const Eigen::Vector2d candidate = from + std::clamp(share, 0.0, 1.0) * along;
      const double distance = (candidate - point).norm();
      if (distance >= min_distance || this->margin(candidate) < margin - kTolerance) continue;
      min_distance = distance;
      nearest = candidate;
    }
    if (std::isfinite(min_distance)) return nearest;
  }
  return point;
}

}  // namespace surefoot
