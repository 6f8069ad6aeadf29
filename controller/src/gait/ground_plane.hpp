// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Plane of the ground under a walking robot: through the mean of the points where the feet stood
/// last, parallel to both diagonals of these points. The normal is low-pass filtered, because a
/// single foot may stand on a step. Real-time: yes.
class GroundPlane {
 public:
  void start(const FeetMatrix& p_world_feet) noexcept;
  /// Move the point of a foot that stands.
  void stand_at(int leg, const Vector3& p_world) noexcept { points_.col(leg) = p_world; }
  /// @param time_constant of the normal [s]
  void update(double time_constant, double dt) noexcept;

  const Vector3& normal() const noexcept { return normal_; }  ///< unit length, upwards
  /// Height of the plane [m] at a world x and y [m].
  double height_at(const Eigen::Vector2d& p_world) const noexcept;

 private:
  FeetMatrix points_ = FeetMatrix::Zero();
  Vector3 normal_ = Vector3::UnitZ();
};

}  // namespace surefoot
