// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "reference/reach_check.hpp"

namespace surefoot {

/// The pose that was latched, in the support frame.
struct LatchedPose {
  Vector3 p_base = Vector3::Zero();
  Quaternion R_base = Quaternion::Identity();
};

/// Moves the body from where it is asked to be now to where it is asked to go: limited in speed
/// and in acceleration, and never faster than it could stop before a pose that the robot could not
/// stand in. Real-time: yes.
class BodyMotion {
 public:
  explicit BodyMotion(const Robot& robot) : reach_check_(robot) {}

  /// Begin anew at a latched pose; q: the joints there.
  void latch(const LatchedPose& pose, const Vector3& p_com, const Eigen::VectorXd& q) noexcept;

  /// Back to the latched pose at once, and no request. p_com() is the last one's until latch().
  void reset() noexcept;

  /// Ask for a pose; anything not finite leaves the last request standing.
  void set_target(const BodyReference& target) noexcept;

  /// Take one step of time. @param feet contact points @param gravity unit, support axes
  void update(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
              double dt) noexcept;

  BodyReference position() const noexcept;
  /// kNotFinite until the next request; else what is in the way.
  ReachStatus status() const noexcept {
    return request_rejected_ ? ReachStatus{ReachLimit::kNotFinite, -1} : limit_;
  }

  // In the support frame:
  Vector3 p_base() const noexcept;
  Quaternion R_base() const noexcept;
  const Vector3& p_com() const noexcept { return p_com_; }  ///< of the robot in this pose
  const Vector3& v_com() const noexcept { return v_com_; }
  Vector3 w_base() const noexcept;      ///< [rad/s]
  Vector3 alpha_base() const noexcept;  ///< [rad/s^2] as far as the rates' own change makes it

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
  double violation_ = 0.0;         // of the present pose
  double unblocked_time_ = 0.0;    // [s] since a limit was last in the way
  std::array<bool, 6> blocked_{};  // axes that a limit is in the way of
  int axis_ = 0;
};

}  // namespace surefoot
