// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

/// The polygon of the stance feet, seen from above. Real-time: yes.
class SupportPolygon {
 public:
  /// @param feet contact points, one column a foot FR FL RR RL; x and y are used
  SupportPolygon(const FeetMatrix& feet, const std::array<bool, kLegs>& stance) noexcept;

  /// Are there three feet or more?
  bool is_valid() const noexcept { return count_ >= 3; }

  int edge_count() const noexcept { return is_valid() ? count_ : 0; }
  struct Edge {
    Eigen::Vector2d outward;  ///< unit length, away from the polygon
    double margin;            ///< how far inside it the point is [m]; negative outside
  };
  /// Edge k, 0 .. edge_count() - 1, as seen from a point.
  Edge edge(int k, const Eigen::Vector2d& point) const noexcept;

  /// Distance of a point inside the nearest edge [m]; negative outside; 0 where there is none.
  double margin(const Eigen::Vector2d& point) const noexcept;

  /// Way to a point from what is nearest to it of the polygon, or of the line between two feet
  /// [m]; nothing inside, and with less than two feet.
  Eigen::Vector2d displacement_outside(const Eigen::Vector2d& point) const noexcept;

 private:
  std::array<Eigen::Vector2d, kLegs> corners_;
  int count_ = 0;
};

}  // namespace surefoot
