// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "reference/reach_check.hpp"

namespace surefoot {

/// Latched pose of the base, in the support frame.
struct LatchedPose {
  Vector3 p_base = Vector3::Zero();
  Quaternion R_base = Quaternion::Identity();
};

/// Trajectory generator of the body pose, from the latched pose to a requested target.
///
/// Gains limit speed and acceleration. In each tick ReachCheck tests the pose in which the body
/// could come to rest. If the robot cannot stand in that pose, the body brakes and the violated
/// limit is reported. Then the body still moves along the axes that this limit does not block.
/// Real-time: yes.
class BodyMotion {
 public:
  explicit BodyMotion(const Robot& robot) : reach_check_(robot) {}

  /// Start at rest in a latched pose.
  /// @param p_com centre of mass at the latch, support frame [m]
  /// @param q configuration at the latch, shape (nq,); initial guess of the inverse kinematics
  void latch(const LatchedPose& pose, const Vector3& p_com, const Eigen::VectorXd& q) noexcept;

  /// Start at rest at the present height, roll and pitch relative to `origin`, the latched pose
  /// from now on; x, y and yaw become 0. The other parameters are those of latch().
  void latch_moved(const LatchedPose& origin, const Vector3& p_com,
                   const Eigen::VectorXd& q) noexcept;
  /// Return the latched pose from which the present height, roll and pitch lead to `pose`.
  LatchedPose origin_of(const LatchedPose& pose) const noexcept;

  /// Move only height, roll and pitch to the target (true), or all coordinates (false).
  void set_walking(bool walking) noexcept {
    // The stand after a walk has a new origin.
    if (walking_ && !walking) target_[0] = target_[1] = target_[5] = 0.0;
    walking_ = walking;
  }

  /// Set the pose and the target to the latched pose at once. p_com() keeps its value until the
  /// next latch() or update().
  void reset() noexcept;

  /// Set the target. A target with NaN or infinity is rejected, and the last valid target is kept.
  void set_target(const BodyReference& target) noexcept;

  /// Move the pose by one tick.
  /// @param feet contact points, support frame [m]
  /// @param gravity unit vector along gravity, support axes
  void update(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
              double dt) noexcept;

  /// Return the present pose (x, y, height, roll, pitch, yaw) relative to the latched pose.
  BodyReference relative_pose() const noexcept;
  /// Return kNotFinite if the last target was rejected. Otherwise return the limit that stops the
  /// motion, or kNone if no limit stops it.
  ReachStatus status() const noexcept {
    return request_rejected_ ? ReachStatus{ReachLimit::kNotFinite, -1} : limit_;
  }

  // The present pose and its derivatives, in the support frame:
  Vector3 p_base() const noexcept;  ///< [m]
  Quaternion R_base() const noexcept;
  const Vector3& p_com() const noexcept { return p_com_; }   ///< [m] centre of mass in this pose
  const Vector3& v_com() const noexcept { return v_com_; }   ///< [m/s]
  double v_height() const noexcept { return velocity_[2]; }  ///< [m/s]
  Vector3 w_base() const noexcept;                           ///< [rad/s]
  /// [rad/s^2] Angular acceleration, from the second derivatives of roll, pitch and yaw. Products
  /// of their rates are neglected.
  Vector3 alpha_base() const noexcept;

 private:
  void stop() noexcept;
  Vector6 target() const noexcept;
  void evaluate_current_pose(const Gains& gains, const FeetMatrix& feet,
                             const Vector3& gravity) noexcept;
  bool at_limit() const noexcept { return limit_.limit != ReachLimit::kNone; }
  bool check_pose(const Gains& gains, const Vector6& relative_pose, const FeetMatrix& feet,
                  const Vector3& gravity) noexcept;
  void probe_axis(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
                  double dt) noexcept;
  Vector6 desired_velocity(const Gains& gains) const noexcept;
  Vector6 limited_change(const Gains& gains, Vector6 change, double dt) const noexcept;
  double half_braking_time(const Gains& gains) const noexcept;
  Quaternion orientation_at(const Vector6& relative_pose) const noexcept;
  Vector3 angular_velocity(const Vector3& rates) const noexcept;

  ReachCheck reach_check_;
  LatchedPose latched_;
  // Poses relative to the latched pose: x, y, height [m]; roll, pitch, yaw [rad]. velocity_ and
  // acceleration_ are the derivatives of relative_pose_.
  bool walking_ = false;  // x, y and yaw stay
  Vector6 target_ = Vector6::Zero(), relative_pose_ = Vector6::Zero();
  Vector6 velocity_ = Vector6::Zero(), acceleration_ = Vector6::Zero();
  // com_offset_: added to the centre of mass of the inverse kinematics (see
  // evaluate_current_pose()).
  Vector3 p_com_ = Vector3::Zero(), v_com_ = Vector3::Zero(), com_offset_ = Vector3::Zero();
  bool just_latched_ = true;
  // [m] Contact points with which the pose was evaluated last.
  FeetMatrix evaluated_feet_ = FeetMatrix::Zero();
  ReachStatus limit_;
  bool request_rejected_ = false;
  double violation_ = 0.0;         // [rad] violation of the present pose, see ReachResult
  double unblocked_time_ = 0.0;    // [s] time since an axis was last blocked
  std::array<bool, 6> blocked_{};  // true for each axis that a limit blocks
  int axis_ = 0;                   // the axis that probe_axis() tested last
};

}  // namespace surefoot
