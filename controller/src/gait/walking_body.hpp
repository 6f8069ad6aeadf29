// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Commanded velocity in the heading frame: x forward, y left.
struct VelocityCommand {
  double vx = 0.0, vy = 0.0;  ///< [m/s]
  double yaw_rate = 0.0;      ///< [rad/s]
};

/// Reference of the body of a walking robot: it moves with the commanded velocity, which the
/// reference approaches with limited acceleration, near the measured body. Real-time: yes.
class WalkingBody {
 public:
  /// Begin at the measured state.
  void start(const Vector3& p_com, double yaw) noexcept;
  /// @param height of the centre of mass above the ground [m]
  /// @param p_com measured centre of mass [m]
  /// @param ground height of the ground under the feet [m]
  void update(const VelocityCommand& command, double height, double ground, const Vector3& p_com,
              double yaw, double dt) noexcept;
  void write(Reference& reference) const noexcept;

  const VelocityCommand& velocity() const noexcept { return velocity_; }  ///< with the limits
  Eigen::Vector2d v_world() const noexcept { return v_.head<2>(); }       ///< [m/s]
  double yaw() const noexcept { return yaw_; }

 private:
  VelocityCommand velocity_;
  Vector3 p_ = Vector3::Zero(), v_ = Vector3::Zero(), a_ = Vector3::Zero();
  double yaw_ = 0.0;
};

}  // namespace surefoot
