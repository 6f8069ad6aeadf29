// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

/// Polygon of the stance feet, seen from above. Real-time: yes.
class SupportPolygon {
 public:
  /// @param feet contact points, FR FL RR RL; x and y are used
  SupportPolygon(const FeetMatrix& feet, const std::array<bool, kLegs>& stance) noexcept;

  /// Return whether there are at least three feet.
  bool is_valid() const noexcept { return count_ >= 3; }

  int edge_count() const noexcept { return is_valid() ? count_ : 0; }
  struct Edge {
    Eigen::Vector2d outward;  ///< unit length, away from the polygon
    double margin;            ///< [m] distance of the point from it; negative outside
  };
  /// Compute edge k, 0 .. edge_count() - 1, and the margin of a point to it.
  Edge edge(int k, const Eigen::Vector2d& point) const noexcept;

  /// Compute the smallest margin [m] of a point to all edges; negative outside, 0 unless
  /// is_valid().
  double margin(const Eigen::Vector2d& point) const noexcept;

  /// Compute the displacement [m] to a point from the nearest point of the polygon, or of the line
  /// between two feet; zero inside, and with fewer than two feet.
  Eigen::Vector2d displacement_outside(const Eigen::Vector2d& point) const noexcept;

 private:
  std::array<Eigen::Vector2d, kLegs> corners_;
  int count_ = 0;
};

}  // namespace surefoot
