// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Torques that the motors say they make, SDK order [N.m]. Real-time: yes.
inline Vector12 measured_torques(const LowState& state) noexcept {
  Vector12 tau;
  for (int i = 0; i < kMotors; ++i) tau[i] = state.motorState[i].tauEst;
  return tau;
}

/// Joint velocities, SDK order [rad/s]. Real-time: yes.
inline Vector12 measured_speeds(const LowState& state) noexcept {
  Vector12 dq;
  for (int i = 0; i < kMotors; ++i) dq[i] = state.motorState[i].dq;
  return dq;
}

/// Whether lying legs that are told what bears them float: springs hold them where they are, and
/// have nothing to do as long as the legs weigh what the model says, or rest on something. Those of
/// a much smaller robot come up against their springs, all of them. Real-time: yes.
class LegLift {
 public:
  static constexpr double kTime = 0.5;    ///< [s] in all: torques fade in for half of it
  static constexpr double kLook = 0.1;    ///< [s] at its end, over which torques are averaged
  static constexpr double kShare = 0.4;   ///< of what bears a leg that its spring takes back ...
  static constexpr double kMost = 1.3;    ///< ... no more: then something else pushes it
  static constexpr double kCounts = 0.3;  ///< of the greatest such torque: below it a joint is none
  static constexpr double kJoints = 0.8;  ///< share of the joints that must say so

  /// @param measured, model torques of all motors that bear the legs [N.m] @param dt [s]
  void update(const Vector12& measured, const Vector12& model, double dt) noexcept {
    time_ += dt;
    if (time_ <= kTime - kLook) return;
    measured_ += measured;
    model_ += model;
  }
  bool done() const noexcept { return time_ >= kTime; }
  bool too_light() const noexcept {
    const double counts = kCounts * model_.cwiseAbs().maxCoeff();
    int joints = 0, light = 0;
    for (int i = 0; i < kMotors; ++i) {
      if (std::abs(model_[i]) < counts) continue;
      const double back = 1.0 - measured_[i] / model_[i];
      ++joints;
      light += back > kShare && back < kMost;
    }
    return light >= kJoints * joints;
  }

 private:
  Vector12 measured_ = Vector12::Zero(), model_ = Vector12::Zero();  // [N.m] summed up
  double time_ = 0.0;                                                // [s]
};

}  // namespace surefoot
