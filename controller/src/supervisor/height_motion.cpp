// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/height_motion.hpp"

#include <algorithm>
#include <cmath>

#include "supervisor/smooth.hpp"

namespace surefoot {

namespace {

constexpr double kAcceleration = 2.0;  // [1/s^2]: a body's 2 m/s^2 at most, far inside friction
constexpr double kLeast = 0.01;        // [1/s] of the last bit of the way
constexpr double kLoaded = 0.25;       // of the way, in which the legs take over the weight
constexpr double kFadeTime = 1.0;      // [s] in which what joints were off fades out
constexpr double kBehind = 0.35;       // [rad] that a joint may be behind before the motion waits

}  // namespace

void HeightMotion::start(double s, const Vector12& joints) noexcept {
  s_ = goal_ = s;
  ds_ = waited_ = time_ = 0.0;
  offset_ = joints - plan_.joints_at(s);
  reference_.q = joints;
  reference_.dq.setZero();
}

double HeightMotion::load() const noexcept { return smooth(s_ / kLoaded); }

bool HeightMotion::arrived() const noexcept { return s_ == goal_ && time_ >= kFadeTime; }

const JointReference& HeightMotion::step(const Vector12& measured, double dt) noexcept {
  const double left = goal_ - s_;
  const bool behind = (reference_.q - measured).cwiseAbs().maxCoeff() > kBehind;
  waited_ = behind && left != 0.0 ? waited_ + dt : 0.0;
  // Fast enough to be there soon, slow enough for the power and to stop at the end.
  const double brake = std::sqrt(kAcceleration * std::abs(left));
  double most = std::max(std::min(plan_.rate_at(s_), brake), kLeast);
  if (behind && left > 0.0) most = 0.0;  // on the way down it goes on: there is no better place
  ds_ += std::clamp(std::copysign(most, left) - ds_, -kAcceleration * dt, kAcceleration * dt);
  time_ += dt;
  s_ = std::clamp(s_ + ds_ * dt, 0.0, 1.0);
  if (std::abs(left) <= std::abs(ds_) * dt && ds_ * left >= 0.0) {
    s_ = goal_;
    ds_ = 0.0;
  }
  const double keep = 1.0 - smooth(time_ / kFadeTime);
  const Vector12 q = plan_.joints_at(s_) + keep * offset_;
  reference_.dq = (q - reference_.q) / dt;
  reference_.q = q;
  return reference_;
}

}  // namespace surefoot
