// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Motion of one swing foot. Real-time: yes.
///
/// Horizontally: in each tick, the minimum-jerk motion from the present reference to the foothold,
/// which may move. Vertically: an arc over the line from lift-off to the foothold. The foot reaches
/// the foothold with a downward speed. A foot that meets no ground there continues downwards.
/// Source of the minimum-jerk motion: Flash and Hogan 1985.
class SwingTrajectory {
 public:
  /// Heights and speed, with the scale of the robot applied.
  struct Shape {
    double height;         ///< [m] of the arc
    double landing_speed;  ///< [m/s] downwards
  };

  /// Begin at a foot's present position, at rest.
  void lift_off(const Vector3& p_world) noexcept;

  /// Compute the reference for the present time.
  /// @param foothold position of the contact point at touchdown, world frame [m]
  /// @param progress share of the swing that is over, 0 .. 1
  /// @param time_left until touchdown [s]
  void update(const Shape& shape, const Vector3& foothold, double progress, double swing_time,
              double time_left, double dt) noexcept;

  /// Continue downwards, to a height `lowest` [m]: the foot should have landed and has not.
  void reach_down(double speed, double lowest, double dt) noexcept;

  const Vector3& p_world() const noexcept { return p_; }
  const Vector3& v_world() const noexcept { return v_; }
  const Vector3& a_world() const noexcept { return a_; }

 private:
  void move_horizontally(int axis, double target, double time_left, double dt) noexcept;

  Vector3 p_ = Vector3::Zero(), v_ = Vector3::Zero(), a_ = Vector3::Zero();
  double z_start_ = 0.0;  // [m] height at lift-off
};

}  // namespace surefoot
