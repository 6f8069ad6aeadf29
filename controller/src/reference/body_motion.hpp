// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reference/reach.hpp"

namespace surefoot {

/// The pose that was latched, in the support frame.
struct LatchedPose {
  Vector3 p_base = Vector3::Zero();
  Quaternion R_base = Quaternion::Identity();
};

/// Moves the body from where it is asked to be now to where it is asked to go: limited in speed,
/// smooth in velocity, and never a step that the robot could not stand with. Real-time: yes.
class BodyMotion {
 public:
  explicit BodyMotion(const Robot& robot) : reach_(robot) {}

  /// Begin anew at a latched pose; q: the joints there.
  void latch(const LatchedPose& pose, const Vector3& p_com, const Eigen::VectorXd& q) noexcept;

  /// Ask for a pose; anything not finite leaves the last request standing.
  void set_target(const BodyReference& target) noexcept;

  /// Take one step of time. @param feet contact points @param gravity unit, support axes
  void step(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity, double dt) noexcept;

  BodyReference position() const noexcept;
  const ReachStatus& status() const noexcept { return status_; }

  // In the support frame:
  Vector3 p_base() const noexcept;
  Quaternion R_base() const noexcept;
  const Vector3& p_com() const noexcept { return p_com_; }  ///< of the robot in this pose
  const Vector3& v_com() const noexcept { return v_com_; }
  Vector3 w_base() const noexcept;      ///< [rad/s]
  Vector3 alpha_base() const noexcept;  ///< [rad/s^2] as far as the rates' own change makes it

 private:
  Vector6 next(const Gains& gains, double dt) noexcept;
  bool take(const Gains& gains, const Vector6& position, const FeetMatrix& feet,
            const Vector3& gravity) noexcept;
  void creep(const Gains& gains, const Vector6& wanted, const FeetMatrix& feet,
             const Vector3& gravity) noexcept;
  Quaternion turned(const Vector6& position) const noexcept;
  Vector3 from_rates(const Vector3& rates) const noexcept;

  Reach reach_;
  LatchedPose latched_;
  // x, y, height, roll, pitch, yaw
  Vector6 target_ = Vector6::Zero(), position_ = Vector6::Zero();
  Vector6 velocity_ = Vector6::Zero(), acceleration_ = Vector6::Zero();
  Vector3 p_com_ = Vector3::Zero(), v_com_ = Vector3::Zero();
  ReachStatus status_;
  double violation_ = 0.0;
  double free_time_ = 0.0;  // [s] since a limit was last in the way
  int axis_ = 0;
};

}  // namespace surefoot
