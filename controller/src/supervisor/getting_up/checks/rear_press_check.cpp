// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/checks/rear_press_check.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// The constants are chosen by hand; benchmarks/get_up.py covers them.
//
// [1/s] Largest rate of the path parameter s. If smaller: a rise takes longer. If larger: the press
// takes more power. Smaller than 0.8, the largest rate of RisePlan, because two legs carry the load
// of four.
constexpr double kRate = 0.5;
// [1/s] s is set to its goal once this rate or the present rate would reach the goal in one tick.
constexpr double kMinRate = 0.01;
constexpr double kAcceleration = 4.0;  // [1/s^2] acceleration of s: it reaches kRate in 1/8 s
constexpr double kFollowTime = 0.3;    // [s] pause at full extension, so that the body can follow
constexpr double kSettleTime = 0.1;    // [s] pause before the press, so that the body comes to rest

}  // namespace

void RearPressCheck::start(const Vector12& reference) noexcept {
  q_start_ = reference;
  reference_.q = reference;
  reference_.dq.setZero();
  pressing_ = nose_went_down_ = false;
  tries_ = 0;
  s_ = ds_ = wait_time_ = 0.0;
}

const JointReference& RearPressCheck::step(const Quaternion& R_world_base, double load,
                                           double dt) noexcept {
  update_press(R_world_base, load, dt);
  step_path(dt);
  return reference_;
}

// Start a press after a pause, and end it when the front has moved or the legs are extended. The
// yaw of the body is ignored, because any press changes the yaw of a body that lies on few points.
void RearPressCheck::update_press(const Quaternion& R_world_base, double load, double dt) noexcept {
  const bool at_end = s_ == (pressing_ ? kMaxExtension : 0.0);
  wait_time_ = at_end ? wait_time_ + dt : 0.0;
  if (!pressing_) {
    if (wait_time_ < kSettleTime || passed() || failed()) return;
    R_before_ = R_world_base;
    pressing_ = true;
    return;
  }
  const Eigen::AngleAxisd turned(R_before_.conjugate() * R_world_base);
  const Vector3 turn = turned.angle() * turned.axis();
  nose_went_down_ = turn.y() > kMinNoseDown;
  const bool diagonal_pair = std::abs(turn.x()) > kMaxRoll && load > kDiagonalLoad;
  const bool wrong_motion = diagonal_pair || turn.y() < -kMaxNoseUp;
  if (wrong_motion) nose_went_down_ = false;
  if (!nose_went_down_ && !wrong_motion && wait_time_ < kFollowTime) return;
  // The robot hangs, so no motion of the front is needed: count this press as passed.
  if (!nose_went_down_ && !wrong_motion && load < kMinLoad) nose_went_down_ = true;
  pressing_ = false;
  ++tries_;
}

void RearPressCheck::step_path(double dt) noexcept {
  const double goal = pressing_ ? kMaxExtension : 0.0, remaining = goal - s_;
  // Rate from which s stops at the goal with kAcceleration / 2; the other half is a reserve.
  const double braking_rate = std::sqrt(kAcceleration * std::abs(remaining));
  const double desired = std::copysign(std::min(kRate, braking_rate), remaining);
  ds_ += std::clamp(desired - ds_, -kAcceleration * dt, kAcceleration * dt);
  const Vector12 last_joints = plan_.joints_at(s_);
  s_ += ds_ * dt;
  if (std::abs(remaining) <= std::max(std::abs(ds_), kMinRate) * dt && ds_ * remaining >= 0.0) {
    s_ = goal;
    ds_ = 0.0;
  }
  const Vector12 joints = plan_.joints_at(s_);
  for (int i = kLegJoints * kFirstLeg; i < kMotors; ++i) {
    reference_.q[i] = q_start_[i] + joints[i] - plan_.folded[i];
    reference_.dq[i] = (joints[i] - last_joints[i]) / dt;
  }
}

}  // namespace surefoot
