// SPDX-License-Identifier: BSD-3-Clause
#include "reference/body_motion.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [s] The reported limit is cleared when no axis has been blocked for this time. Chosen. If
// shorter: the status would change from tick to tick. If longer: an operator would see an old
// limit.
constexpr double kLimitHoldTime = 0.1;
// [m], [rad] and [m/s], [rad/s]. The target is reached if all errors of the pose and all velocities
// are below this value. Numerical tolerance.
constexpr double kTargetTolerance = 1e-5;
// [m] Displacement of a foot above which the pose is evaluated again, although the body is at its
// target. Numerical tolerance: ten times kTargetTolerance.
constexpr double kFootTolerance = 1e-4;
// [m], [rad] Largest displacement with which probe_axis() tests an axis. Far above kTolerance of
// StanceKinematics, 1e-6 m.
constexpr double kProbeStep = 1e-3;
// [m], [rad] Largest magnitude of each coordinate of a target. Chosen: beyond any robot's reach.
constexpr double kMaxTarget = 10.0;

Vector6 to_vector(const BodyReference& r) noexcept {
  Vector6 v;
  v << r.x, r.y, r.height, r.roll, r.pitch, r.yaw;
  return v;
}

}  // namespace

void BodyMotion::latch(const LatchedPose& pose, const Vector3& p_com,
                       const Eigen::VectorXd& q) noexcept {
  relative_pose_.setZero();
  latch_moved(pose, p_com, q);
}

void BodyMotion::latch_moved(const LatchedPose& origin, const Vector3& p_com,
                             const Eigen::VectorXd& q) noexcept {
  latched_ = origin;
  p_com_ = p_com;
  reach_check_.set_initial_guess(q);
  relative_pose_[0] = relative_pose_[1] = relative_pose_[5] = 0.0;
  just_latched_ = true;
  evaluated_feet_.setConstant(kMaxTarget);  // forces an evaluation of the pose in the next update()
  stop();
}

LatchedPose BodyMotion::origin_of(const LatchedPose& pose) const noexcept {
  const Quaternion offset =
      exp_so3(relative_pose_[4] * Vector3::UnitY()) * exp_so3(relative_pose_[3] * Vector3::UnitX());
  return {pose.p_base - relative_pose_[2] * Vector3::UnitZ(), offset.conjugate() * pose.R_base};
}

void BodyMotion::reset() noexcept {
  target_.setZero();
  relative_pose_.setZero();
  request_rejected_ = false;
  stop();
}

void BodyMotion::stop() noexcept {
  velocity_.setZero();
  acceleration_.setZero();
  v_com_.setZero();
  blocked_.fill(false);
  limit_ = {};
}

Vector6 BodyMotion::target() const noexcept {
  Vector6 target = target_;
  if (walking_) target[0] = target[1] = target[5] = 0.0;
  return target;
}

void BodyMotion::set_target(const BodyReference& target) noexcept {
  const Vector6 desired = to_vector(target);
  request_rejected_ = !desired.allFinite();
  if (request_rejected_) return;
  target_ = desired.cwiseMin(kMaxTarget).cwiseMax(-kMaxTarget);
}

void BodyMotion::update(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
                        double dt) noexcept {
  const bool at_target = (target() - relative_pose_).cwiseAbs().maxCoeff() < kTargetTolerance &&
                         velocity_.cwiseAbs().maxCoeff() < kTargetTolerance;
  if (at_target) stop();
  if (at_target && (feet - evaluated_feet_).cwiseAbs().maxCoeff() < kFootTolerance) return;
  evaluate_current_pose(gains, feet, gravity);
  if (at_target) return;
  if (at_limit()) probe_axis(gains, feet, gravity, dt);
  const Vector6 previous_velocity = velocity_;
  velocity_ =
      previous_velocity + limited_change(gains, desired_velocity(gains) - previous_velocity, dt);
  // Continue only if the pose in which the body could come to rest is acceptable; otherwise brake.
  const double lookahead_time = half_braking_time(gains) + dt;
  if (check_pose(gains, relative_pose_ + lookahead_time * velocity_, feet, gravity)) {
    v_com_ = (reach_check_.p_com() + com_offset_ - p_com_) / lookahead_time;
  } else {
    velocity_ = previous_velocity + limited_change(gains, -previous_velocity, dt);
    v_com_.setZero();
    blocked_.fill(true);
    unblocked_time_ = 0.0;
  }
  acceleration_ = (velocity_ - previous_velocity) / dt;
  relative_pose_ += velocity_ * dt;
  p_com_ += v_com_ * dt;
}

// Evaluate the present pose with the present feet. Set the centre of mass, and violation_, which
// the violation of the next pose must not exceed.
void BodyMotion::evaluate_current_pose(const Gains& gains, const FeetMatrix& feet,
                                       const Vector3& gravity) noexcept {
  const ReachResult current = reach_check_.evaluate(gains, p_base(), R_base(), feet, gravity);
  violation_ = current.violation;
  evaluated_feet_ = feet;
  if (current.status.limit == ReachLimit::kUnreachable) return;
  // The latched joint angles and the inverse kinematics of the latched pose differ, because the
  // ground normal was not known exactly at the latch. com_offset_ compensates this difference, so
  // that the latch does not move the body.
  if (just_latched_) com_offset_ = p_com_ - reach_check_.p_com();
  just_latched_ = false;
  p_com_ = reach_check_.p_com() + com_offset_;
}

// Return whether the body may move to a pose, given like relative_pose_. If not, write the reason
// to limit_. A pose outside the limits is acceptable if its violation is at most that of the
// present pose. Without this rule, a push that displaces feet could put the present pose outside
// the limits, and the body could not move any more.
bool BodyMotion::check_pose(const Gains& gains, const Vector6& relative_pose,
                            const FeetMatrix& feet, const Vector3& gravity) noexcept {
  const ReachResult result = reach_check_.evaluate(gains, latched_.p_base + relative_pose.head<3>(),
                                                   orientation_at(relative_pose), feet, gravity);
  if (result.status.limit != ReachLimit::kUnreachable && result.violation <= violation_) {
    return true;
  }
  limit_ = result.status;
  return false;
}

// At a limit, test one axis in each tick: may the body move along this axis towards the target?
void BodyMotion::probe_axis(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
                            double dt) noexcept {
  axis_ = (axis_ + 1) % 6;
  const ReachStatus reason = limit_;
  Vector6 relative_pose = relative_pose_;
  relative_pose[axis_] +=
      std::clamp(target()[axis_] - relative_pose_[axis_], -kProbeStep, kProbeStep);
  blocked_[axis_] = !check_pose(gains, relative_pose, feet, gravity);
  // Clear the limit when no axis has been blocked for kLimitHoldTime.
  unblocked_time_ = blocked_[axis_] ? 0.0 : unblocked_time_ + dt;
  limit_ = unblocked_time_ > kLimitHoldTime ? ReachStatus{} : reason;
}

// Compute the velocity along a straight line to the target, with zero on blocked axes. The speed is
// limited to the speed gains, and to the speed from which the body can still stop at the target.
Vector6 BodyMotion::desired_velocity(const Gains& gains) const noexcept {
  Vector6 to_target = target() - relative_pose_;
  for (int axis = 0; axis < 6; ++axis) {
    if (blocked_[axis]) to_target[axis] = 0.0;
  }
  Vector6 desired = to_target / gains.reference_time;
  const auto limit_speed = [&](int first, double speed, double acceleration) {
    const double braking_speed = std::sqrt(2.0 * acceleration * to_target.segment<3>(first).norm());
    const double max_speed = std::min(speed, braking_speed);
    desired.segment<3>(first) *=
        max_speed / std::max(desired.segment<3>(first).norm(), std::max(max_speed, 1e-12));
  };
  limit_speed(0, gains.reference_speed, gains.reference_acceleration);
  limit_speed(3, gains.reference_turn_speed, gains.reference_turn_acceleration);
  return desired;
}

// Scale a velocity change so that the linear and the angular acceleration stay within their gains.
Vector6 BodyMotion::limited_change(const Gains& gains, Vector6 change, double dt) const noexcept {
  const double max_change = gains.reference_acceleration * dt;
  const double max_turn_change = gains.reference_turn_acceleration * dt;
  change.head<3>() *= max_change / std::max(change.head<3>().norm(), max_change);
  change.tail<3>() *= max_turn_change / std::max(change.tail<3>().norm(), max_turn_change);
  return change;
}

// Compute half of the braking time, v / (2 a), where v is the speed and a the acceleration gain.
// The braking distance is v^2 / (2 a), so the body comes to rest at relative_pose_ + velocity_
// times this time. The result is the larger one of translation and rotation.
double BodyMotion::half_braking_time(const Gains& gains) const noexcept {
  return 0.5 * std::max(velocity_.head<3>().norm() / gains.reference_acceleration,
                        velocity_.tail<3>().norm() / gains.reference_turn_acceleration);
}

BodyReference BodyMotion::relative_pose() const noexcept {
  return {relative_pose_[0], relative_pose_[1], relative_pose_[2],
          relative_pose_[3], relative_pose_[4], relative_pose_[5]};
}

Vector3 BodyMotion::p_base() const noexcept { return latched_.p_base + relative_pose_.head<3>(); }
Quaternion BodyMotion::R_base() const noexcept { return orientation_at(relative_pose_); }
Vector3 BodyMotion::w_base() const noexcept { return angular_velocity(velocity_.tail<3>()); }
Vector3 BodyMotion::alpha_base() const noexcept {
  return angular_velocity(acceleration_.tail<3>());
}

Quaternion BodyMotion::orientation_at(const Vector6& relative_pose) const noexcept {
  return exp_so3(relative_pose[5] * Vector3::UnitZ()) *
         exp_so3(relative_pose[4] * Vector3::UnitY()) *
         exp_so3(relative_pose[3] * Vector3::UnitX()) * latched_.R_base;
}

// Convert the rates of roll, pitch and yaw to an angular velocity in the support frame. The pitch
// axis rotates with yaw; the roll axis rotates with yaw and pitch.
Vector3 BodyMotion::angular_velocity(const Vector3& rates) const noexcept {
  const Quaternion Rz = exp_so3(relative_pose_[5] * Vector3::UnitZ());
  const Quaternion Rzy = Rz * exp_so3(relative_pose_[4] * Vector3::UnitY());
  return rates[2] * Vector3::UnitZ() + Rz * (rates[1] * Vector3::UnitY()) +
         Rzy * (rates[0] * Vector3::UnitX());
}

}  // namespace surefoot
