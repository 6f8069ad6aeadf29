// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

/// Polygon of the stance feet, seen from above. Real-time: yes.
class SupportPolygon {
 public:
  /// @param feet contact points, FR FL RR RL [m]; only x and y are used
  /// @param stance true for each foot that is a corner of the polygon
  SupportPolygon(const FeetMatrix& feet, const std::array<bool, kLegs>& stance) noexcept;

  /// Return whether the polygon has at least three corners.
  bool is_valid() const noexcept { return count_ >= 3; }

  int edge_count() const noexcept { return is_valid() ? count_ : 0; }
  struct Edge {
    Eigen::Vector2d outward;  ///< normal of the edge, unit length, away from the polygon
    /// [m] Distance from the edge line to the point that edge() received; negative: outside.
    double margin;
  };
  /// Compute the normal of edge k, 0 .. edge_count() - 1, and the margin of a point at this edge.
  Edge edge(int k, const Eigen::Vector2d& point) const noexcept {
    return {outward_[k], outward_[k].dot(corners_[k] - point)};
  }

  /// Compute the smallest margin [m] of a point at any edge. Negative: the point is outside. If
  /// is_valid() is false, return 0.
  double margin(const Eigen::Vector2d& point) const noexcept;

  /// Compute the nearest point to `point` whose margin is at least `margin` [m]. If the polygon is
  /// too narrow for this margin, the largest of its halves, quarters ... that fits counts. If
  /// is_valid() is false, return `point`.
  Eigen::Vector2d nearest_inside(const Eigen::Vector2d& point, double margin) const noexcept;

 private:
  int after(int k) const noexcept { return k + 1 == count_ ? 0 : k + 1; }
  int before(int k) const noexcept { return k == 0 ? count_ - 1 : k - 1; }
  Eigen::Vector2d inset_corner(int k, double margin) const noexcept;

  std::array<Eigen::Vector2d, kLegs> corners_;  // counter-clockwise
  std::array<Eigen::Vector2d, kLegs> outward_;  // unit normals of the edges from corner k to k + 1
  int count_ = 0;
};

}  // namespace surefoot
