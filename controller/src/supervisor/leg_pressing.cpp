// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/leg_pressing.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kRate = 0.5;          // [1/s] of the way
constexpr double kLeast = 0.01;        // [1/s] of the last bit of it
constexpr double kAcceleration = 4.0;  // [1/s^2]
constexpr double kPatience = 0.3;      // [s] at the end of the way, for the body to follow
constexpr double kRest = 0.1;          // [s] before, for it to lie still

}  // namespace

void LegPressing::start(const Vector12& reference) noexcept {
  start_ = reference;
  reference_.q = reference;
  reference_.dq.setZero();
  pressing_ = seen_ = false;
  tries_ = 0;
  s_ = ds_ = waited_ = 0.0;
}

const JointReference& LegPressing::step(const Quaternion& R_world_base, double borne,
                                        double dt) noexcept {
  watch(R_world_base, borne, dt);
  move(dt);
  return reference_;
}

// The heading does not count: a body that lies on few points is turned by any press.
void LegPressing::watch(const Quaternion& R_world_base, double borne, double dt) noexcept {
  const bool at_end = s_ == (pressing_ ? kMost : 0.0);
  waited_ = at_end ? waited_ + dt : 0.0;
  if (!pressing_) {
    if (waited_ < kRest || passed() || failed()) return;
    R_before_ = R_world_base;
    pressing_ = true;
    return;
  }
  const Eigen::AngleAxisd turned(R_before_.conjugate() * R_world_base);
  const Vector3 turn = turned.angle() * turned.axis();
  seen_ = turn.y() > kSeen;
  const bool diagonal = std::abs(turn.x()) > kRoll && borne > kBothBear;
  const bool elsewhere = diagonal || turn.y() < -kNoseUp;
  if (elsewhere) seen_ = false;
  if (!seen_ && !elsewhere && waited_ < kPatience) return;
  if (!seen_ && !elsewhere && borne < kBorne) seen_ = true;
  pressing_ = false;
  ++tries_;
}

void LegPressing::move(double dt) noexcept {
  const double goal = pressing_ ? kMost : 0.0, left = goal - s_;
  const double brake = std::sqrt(kAcceleration * std::abs(left));
  const double wanted = std::copysign(std::min(kRate, brake), left);
  ds_ += std::clamp(wanted - ds_, -kAcceleration * dt, kAcceleration * dt);
  const Vector12 before = plan_.joints_at(s_);
  s_ += ds_ * dt;
  if (std::abs(left) <= std::max(std::abs(ds_), kLeast) * dt && ds_ * left >= 0.0) {
    s_ = goal;
    ds_ = 0.0;
  }
  const Vector12 now = plan_.joints_at(s_);
  for (int i = kLegJoints * kFirst; i < kMotors; ++i) {
    reference_.q[i] = start_[i] + now[i] - plan_.folded[i];
    reference_.dq[i] = (now[i] - before[i]) / dt;
  }
}

}  // namespace surefoot
