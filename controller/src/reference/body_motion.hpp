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
/// Speed and acceleration are limited by gains. In each tick ReachCheck tests the pose in which the
/// body could come to a stop; if the robot could not stand there, the body brakes. At a limit, the
/// axes that are still free continue. Real-time: yes.
class BodyMotion {
 public:
  explicit BodyMotion(const Robot& robot) : reach_check_(robot) {}

  /// Start at a latched pose, at rest.
  /// @param q joint angles and base pose of the latch, shape (nq,), start of inverse kinematics
  void latch(const LatchedPose& pose, const Vector3& p_com, const Eigen::VectorXd& q) noexcept;

  /// Return to the latched pose at once and drop the target. p_com() is unchanged until latch().
  void reset() noexcept;

  /// Set the target. A target with NaN or infinity is rejected; the last one stays in force.
  void set_target(const BodyReference& target) noexcept;

  /// Move by one tick.
  /// @param feet contact points @param gravity direction, unit length; both in support axes
  void update(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
              double dt) noexcept;

  BodyReference position() const noexcept;
  /// kNotFinite while the last target was rejected, else the limit that stops the motion.
  ReachStatus status() const noexcept {
    return request_rejected_ ? ReachStatus{ReachLimit::kNotFinite, -1} : limit_;
  }

  // In the support frame:
  Vector3 p_base() const noexcept;
  Quaternion R_base() const noexcept;
  const Vector3& p_com() const noexcept { return p_com_; }  ///< centre of mass in this pose
  const Vector3& v_com() const noexcept { return v_com_; }
  Vector3 w_base() const noexcept;      ///< [rad/s]
  Vector3 alpha_base() const noexcept;  ///< [rad/s^2] from roll, pitch, yaw rates' change

 private:
  void stop() noexcept;
  void evaluate_current_pose(const Gains& gains, const FeetMatrix& feet,
                             const Vector3& gravity) noexcept;
  bool at_limit() const noexcept { return limit_.limit != ReachLimit::kNone; }
  bool acceptable(const Gains& gains, const Vector6& position, const FeetMatrix& feet,
                  const Vector3& gravity) noexcept;
  void probe_axis(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
                  double dt) noexcept;
  Vector6 desired_velocity(const Gains& gains) const noexcept;
  Vector6 limited_change(const Gains& gains, Vector6 change, double dt) const noexcept;
  double stopping_time(const Gains& gains) const noexcept;
  Quaternion orientation_at(const Vector6& position) const noexcept;
  Vector3 angular_velocity(const Vector3& rates) const noexcept;

  ReachCheck reach_check_;
  LatchedPose latched_;
  // x, y, height, roll, pitch, yaw
  Vector6 target_ = Vector6::Zero(), position_ = Vector6::Zero();
  Vector6 velocity_ = Vector6::Zero(), acceleration_ = Vector6::Zero();
  Vector3 p_com_ = Vector3::Zero(), v_com_ = Vector3::Zero(), com_offset_ = Vector3::Zero();
  bool just_latched_ = true;
  FeetMatrix evaluated_feet_ = FeetMatrix::Zero();
  ReachStatus limit_;
  bool request_rejected_ = false;
  double violation_ = 0.0;         // violation of the present pose
  double unblocked_time_ = 0.0;    // [s] since an axis was last blocked
  std::array<bool, 6> blocked_{};  // axes that a limit blocks
  int axis_ = 0;
};

}  // namespace surefoot
