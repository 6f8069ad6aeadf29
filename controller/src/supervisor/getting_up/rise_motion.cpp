// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/rise_motion.hpp"

#include <algorithm>
#include <cmath>

#include "supervisor/common/smoothstep.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand. benchmarks/get_up.py covers them; test_supervisor.cpp tests
// that the motion is continuous.
//
// [1/s^2] Acceleration of the path parameter s. It accelerates the body by less than 2 m/s^2, far
// below the limit of friction.
constexpr double kAcceleration = 2.0;
// [1/s] Smallest rate near the goal, so that s arrives in finite time.
constexpr double kMinRate = 0.01;
constexpr double kLoadingRange = 0.25;  // s at which the legs carry the full weight
// [s] Time over which the initial offset from the path is faded out. Shorter than 1.25 s, the
// shortest duration of RisePlan's path.
constexpr double kFadeTime = 1.0;
// [rad] The motion waits if a joint lags behind by more than this. Larger than the sag of the
// springs (3 degrees), and smaller than kMaxDeflection of JointImpedance.
constexpr double kMaxLag = 0.35;

}  // namespace

void RiseMotion::start(double s, const Vector12& joints) noexcept {
  s_ = goal_ = s;
  ds_ = stalled_time_ = time_ = 0.0;
  offset_ = joints - plan_.joints_at(s);
  reference_.q = joints;
  reference_.dq.setZero();
}

double RiseMotion::load() const noexcept { return smoothstep(s_ / kLoadingRange); }

bool RiseMotion::arrived() const noexcept { return s_ == goal_ && time_ >= kFadeTime; }

const JointReference& RiseMotion::step(const Vector12& measured, double dt) noexcept {
  const double remaining = goal_ - s_;
  const bool lagging = (reference_.q - measured).cwiseAbs().maxCoeff() > kMaxLag;
  stalled_time_ = lagging && remaining != 0.0 ? stalled_time_ + dt : 0.0;
  // Limit the rate to the plan's rate, which limits power, and to the rate from which the motion
  // stops at the goal with kAcceleration / 2: sqrt(2 (kAcceleration / 2) |remaining|). The other
  // half of kAcceleration is a reserve.
  const double braking_rate = std::sqrt(kAcceleration * std::abs(remaining));
  double max_rate = std::max(std::min(plan_.rate_at(s_), braking_rate), kMinRate);
  if (lagging && remaining > 0.0)
    max_rate = 0.0;  // the motion down does not wait: no pose on its path is safer than lying
  ds_ +=
      std::clamp(std::copysign(max_rate, remaining) - ds_, -kAcceleration * dt, kAcceleration * dt);
  time_ += dt;
  s_ = std::clamp(s_ + ds_ * dt, 0.0, 1.0);
  if (std::abs(remaining) <= std::abs(ds_) * dt && ds_ * remaining >= 0.0) {
    s_ = goal_;
    ds_ = 0.0;
  }
  const double offset_share = 1.0 - smoothstep(time_ / kFadeTime);
  const Vector12 q = plan_.joints_at(s_) + offset_share * offset_;
  reference_.dq = (q - reference_.q) / dt;
  reference_.q = q;
  return reference_;
}

}  // namespace surefoot
