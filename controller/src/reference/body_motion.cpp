// SPDX-License-Identifier: BSD-3-Clause
#include "reference/body_motion.hpp"

#include <algorithm>

namespace surefoot {

namespace {

constexpr double kFreeTime = 0.1;  // [s] without a limit in the way before it is forgotten
constexpr double kThere = 1e-5;    // [m], [rad] from the target counts as there

Vector6 to_vector(const BodyReference& r) noexcept {
  Vector6 v;
  v << r.x, r.y, r.height, r.roll, r.pitch, r.yaw;
  return v;
}

}  // namespace

void BodyMotion::latch(const LatchedPose& pose, const Vector3& p_com,
                       const Eigen::VectorXd& q) noexcept {
  latched_ = pose;
  p_com_ = p_com;
  reach_.start_from(q);
  position_.setZero();
  velocity_.setZero();
  acceleration_.setZero();
  v_com_.setZero();
  status_ = {};
  violation_ = 0.0;
}

void BodyMotion::set_target(const BodyReference& target) noexcept {
  const Vector6 wanted = to_vector(target);
  if (wanted.allFinite()) {
    target_ = wanted;
    status_ = {};
  } else {
    status_ = {ReachLimit::kNotFinite, -1};
  }
}

void BodyMotion::step(const Gains& gains, const FeetMatrix& feet, const Vector3& gravity,
                      double dt) noexcept {
  const bool there = (target_ - position_).cwiseAbs().maxCoeff() < kThere;
  if (there && velocity_.cwiseAbs().maxCoeff() < kThere) {
    velocity_.setZero();
    acceleration_.setZero();
    v_com_.setZero();
    if (status_.limit != ReachLimit::kNotFinite) status_ = {};
    return;
  }
  const Vector3 before = p_com_;
  const Vector6 wanted = next(gains, dt);
  const ReachStatus reason = status_;
  if (take(gains, wanted, feet, gravity)) {
    // Creeping along a limit gets through now and then: free is what has been free for a while.
    free_time_ += dt;
    status_ = free_time_ > kFreeTime ? ReachStatus{} : reason;
    v_com_ = (p_com_ - before) / dt;
  } else {
    free_time_ = 0.0;
    creep(gains, wanted, feet, gravity);
    v_com_.setZero();
  }
}

// Critically damped towards the target, at limited speed, in a straight line.
Vector6 BodyMotion::next(const Gains& gains, double dt) noexcept {
  Vector6 wanted = (target_ - position_) / gains.reference_time;
  wanted.head<3>() *=
      gains.reference_speed / std::max(wanted.head<3>().norm(), gains.reference_speed);
  wanted.tail<3>() *=
      gains.reference_turn_speed / std::max(wanted.tail<3>().norm(), gains.reference_turn_speed);
  const double blend = dt / (dt + 0.25 * gains.reference_time);
  const Vector6 velocity = velocity_ + blend * (wanted - velocity_);
  acceleration_ = (velocity - velocity_) / dt;
  velocity_ = velocity;
  return position_ + velocity_ * dt;
}

// A pose that is no worse than the present one may be taken even if it is out of bounds: feet that
// were pushed away must not nail the body to where it is.
bool BodyMotion::take(const Gains& gains, const Vector6& position, const FeetMatrix& feet,
                      const Vector3& gravity) noexcept {
  const ReachVerdict verdict =
      reach_.judge(gains, latched_.p_base + position.head<3>(), turned(position), feet, gravity);
  if (verdict.violation > violation_) {
    status_ = verdict.status;
    return false;
  }
  violation_ = verdict.violation;
  position_ = position;
  p_com_ = reach_.p_com();
  return true;
}

// The whole step is too much: take what part of it is not, one axis a tick.
void BodyMotion::creep(const Gains& gains, const Vector6& wanted, const FeetMatrix& feet,
                       const Vector3& gravity) noexcept {
  const ReachStatus reason = status_;
  axis_ = (axis_ + 1) % 6;
  Vector6 position = position_;
  position[axis_] = wanted[axis_];
  const bool moves = std::abs(target_[axis_] - position_[axis_]) > kThere;
  const double speed = velocity_[axis_];
  acceleration_.setZero();
  if (moves && take(gains, position, feet, gravity)) {
    velocity_.setZero();
    velocity_[axis_] = speed;
  } else {
    velocity_.setZero();
  }
  status_ = reason;
}

BodyReference BodyMotion::position() const noexcept {
  return {position_[0], position_[1], position_[2], position_[3], position_[4], position_[5]};
}

Vector3 BodyMotion::p_base() const noexcept { return latched_.p_base + position_.head<3>(); }
Quaternion BodyMotion::R_base() const noexcept { return turned(position_); }
Vector3 BodyMotion::w_base() const noexcept { return from_rates(velocity_.tail<3>()); }
Vector3 BodyMotion::alpha_base() const noexcept { return from_rates(acceleration_.tail<3>()); }

Quaternion BodyMotion::turned(const Vector6& position) const noexcept {
  return exp_so3(position[5] * Vector3::UnitZ()) * exp_so3(position[4] * Vector3::UnitY()) *
         exp_so3(position[3] * Vector3::UnitX()) * latched_.R_base;
}

// Angular velocity from the rates of roll, pitch and yaw: each turns what comes after it.
Vector3 BodyMotion::from_rates(const Vector3& rates) const noexcept {
  const Quaternion Rz = exp_so3(position_[5] * Vector3::UnitZ());
  const Quaternion Rzy = Rz * exp_so3(position_[4] * Vector3::UnitY());
  return rates[2] * Vector3::UnitZ() + Rz * (rates[1] * Vector3::UnitY()) +
         Rzy * (rates[0] * Vector3::UnitX());
}

}  // namespace surefoot
