// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_sway.hpp"
#include "gait/gait_size.hpp"
#include "gait/ground_plane.hpp"
#include "gait/velocity_change.hpp"
#include "reference/body_motion.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Horizontal motion and heading of a body, measured or planned, world axes.
struct HorizontalMotion {
  Eigen::Vector2d p_com, v_com;  ///< [m], [m/s]
  double yaw;                    ///< [rad]
};

/// Trajectory of the body of a walking robot. Real-time: yes.
///
/// Its velocity approaches the command with limited acceleration. Its position integrates the
/// velocity, but stays near the measured body, so that the robot does not rush back after a push.
/// The centre of mass stays at the height of the standing pose over the ground plane, along
/// gravity; the base is parallel to the ground plane, but for the offset that a BodyReference
/// requests.
class BodyTrajectory {
 public:
  explicit BodyTrajectory(const GaitSize& size) : size_(size) {}

  /// Begin at the measured state, at velocity 0.
  void start(const HorizontalMotion& measured, double height) noexcept;
  /// @param acceleration_share factor, 0 .. 1, on the gains walk_acceleration and
  ///   walk_turn_acceleration
  void update(const Gains& gains, const WalkVelocity& command, const HorizontalMotion& measured,
              double acceleration_share, double dt) noexcept;
  /// Write the body's part of the reference, `ahead` seconds later than this tick.
  /// @param offset height, roll and pitch of the body relative to those of the standing pose
  void write(const GroundPlane& ground, const BodySway& sway, const BodyMotion& offset,
             double ahead, Reference& reference) const noexcept;

  /// Motion of the trajectory, without sway.
  HorizontalMotion motion() const noexcept { return {p_, v_, yaw_}; }
  const WalkVelocity& velocity() const noexcept { return velocity_; }  ///< of the trajectory
  Eigen::Vector2d v_world() const noexcept { return v_; }              ///< [m/s]
  Eigen::Vector2d a_world() const noexcept { return a_; }              ///< [m/s^2]
  double yaw() const noexcept { return yaw_; }                         ///< [rad]
  /// The change of velocity towards the command, without the centripetal acceleration of a curve.
  const VelocityChange& change() const noexcept { return change_; }

 private:
  void update_velocity(const Gains& gains, const WalkVelocity& command, double acceleration_share,
                       double dt) noexcept;

  GaitSize size_;
  WalkVelocity velocity_;
  Eigen::Vector2d p_ = Eigen::Vector2d::Zero(), v_ = p_, a_ = p_;  // world axes
  VelocityChange change_;
  double yaw_ = 0.0;     // [rad]
  double height_ = 0.0;  // [m] above the ground plane
};

}  // namespace surefoot
