// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/leg_folding.hpp"

#include <algorithm>
#include <cmath>

#include "supervisor/smooth.hpp"

namespace surefoot {

namespace {

constexpr double kSpeed = 1.2;          // [rad/s]
constexpr double kAcceleration = 15.0;  // [rad/s^2]
constexpr double kPull = 4.0;           // [1/s] how the reference ends
constexpr double kLead = 0.4;           // [rad] that it may run ahead of its joint
constexpr double kKneeBeside = 1.3;     // [rad] thigh: up to here the hip is turned outward ...
constexpr double kKneeUp = 2.2;         // ... and from here on it is straight
constexpr double kKneeBack = 1.9;  // [rad] thigh: where a knee that leans over the body goes ...
constexpr double kHipOff = 0.2;    // [rad] until its hip is as near as this ...
constexpr double kGently = 4.0;    // [s] but no longer
constexpr double kThere = 0.005;   // [rad] of the reference
constexpr double kNear = 0.25;     // [rad] of the joints: friction and the ground hold them

}  // namespace

void LegFolding::start(const Vector12& measured) noexcept {
  reference_.q = measured;
  reference_.dq.setZero();
  time_ = 0.0;
  done_ = false;
}

Vector12 LegFolding::target(const Vector12& measured) const noexcept {
  Vector12 target = plan_.folded;
  for (int hip = 0; hip < kMotors; hip += kLegJoints) {
    const double thigh = std::abs(reference_.q[hip + 1]);
    target[hip] +=
        plan_.wide[hip] * (1.0 - smooth((thigh - kKneeBeside) / (kKneeUp - kKneeBeside)));
    const bool leans = thigh > kKneeBeside && std::abs(target[hip] - measured[hip]) > kHipOff;
    if (leans && time_ < kGently) target[hip + 1] = std::copysign(kKneeBack, target[hip + 1]);
  }
  return target;
}

const JointReference& LegFolding::step(const Vector12& measured, double dt) noexcept {
  time_ += dt;
  const Vector12 wanted = target(measured);
  for (int i = 0; i < kMotors; ++i) {
    double &q = reference_.q[i], &dq = reference_.dq[i];
    const double ahead = std::abs(q - measured[i]) / kLead;
    const double most = kSpeed * std::clamp(2.0 * (1.0 - ahead), 0.0, 1.0);
    const double speed = std::clamp(kPull * (wanted[i] - q), -most, most);
    dq += std::clamp(speed - dq, -kAcceleration * dt, kAcceleration * dt);
    q += dq * dt;
  }
  done_ = (plan_.folded - reference_.q).cwiseAbs().maxCoeff() < kThere &&
          (plan_.folded - measured).cwiseAbs().maxCoeff() < kNear;
  return reference_;
}

}  // namespace surefoot
