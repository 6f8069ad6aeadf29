// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Where the feet are: the frame that standing refers to.
///
/// World x, y and yaw of a legged robot drift; a reference that stayed there would lean the robot
/// off its feet. The feet themselves do not drift.
struct SupportFrame {
  Vector3 centroid = Vector3::Zero();  ///< [m] mean of the four contact points, world
  double heading = 0.0;                ///< [rad] from the rear feet's middle to the front's
  Vector3 normal = Vector3::UnitZ();   ///< of the plane through the feet, upwards

  /// Axes of the frame: z along a normal (given, so that it may be smoothed), x towards `heading`.
  Matrix3 R_world_support(const Vector3& smooth_normal) const noexcept;
};

/// Fit the frame to the contact points, one column a foot, world axes. Real-time: yes.
///
/// The plane's normal is normal to both diagonals, i.e. to the plane closest to the four points.
SupportFrame fit_support_frame(const FeetMatrix& p_world_feet) noexcept;

}  // namespace surefoot
