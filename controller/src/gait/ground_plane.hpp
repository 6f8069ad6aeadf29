// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Plane of the ground under a walking robot: through the mean of the points where the feet stood
/// last, parallel to both diagonals of these points. The normal is low-pass filtered, because a
/// single foot may stand on a step. The height under the body is filtered too, but only its jumps:
/// on a slope it does not lag. Real-time: yes.
class GroundPlane {
 public:
  /// Begin with the plane of a standing robot.
  /// @param contact contact confidence per foot, 0 .. 1; the point of a foot without contact
  ///   is projected onto the plane
  /// @param normal of the ground under the stand, unit length
  /// @param sink mean depth by which the soles yield [m]
  void start(const FeetMatrix& p_world_feet, const Eigen::Vector4d& contact, const Vector3& normal,
             double sink = 0.0) noexcept;
  /// Move the point of a foot that stands.
  void stand_at(int leg, const Vector3& p_world) noexcept { points_.col(leg) = p_world; }
  /// @param time unit of the time constants: sqrt(h/g) [s]
  /// @param p_world position of the body [m]
  /// @param sink mean depth by which the soles yield [m]
  void update(double time, const Eigen::Vector2d& p_world, double sink, double dt) noexcept;

  const Vector3& normal() const noexcept { return normal_; }  ///< unit length, upwards
  /// Height of the plane [m] at a world x and y [m].
  double height_at(const Eigen::Vector2d& p_world) const noexcept;
  /// Height of the ground under the loaded soles [m]: that of the plane minus the mean sink. Jumps
  /// of the plane, when a foot lands on a step, are low-pass filtered.
  double height_of_soles(const Eigen::Vector2d& p_world) const noexcept {
    return height_at(p_world) - jump_ - sink_;
  }

 private:
  FeetMatrix points_ = FeetMatrix::Zero();
  Vector3 mean_ = Vector3::Zero();  // of the points [m]
  Vector3 normal_ = Vector3::UnitZ();
  double jump_ = 0.0;  // [m] part of the height's changes that height_of_soles() leaves out
  double sink_ = 0.0;  // [m] mean sink of the soles, filtered
};

}  // namespace surefoot
