// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Holds each joint's angle against its own speed: an angle that jumps is not to be acted upon.
/// Real-time: yes.
class JointMonitor {
 public:
  static constexpr double kMaxJump = 0.08;         ///< [rad] more than its speed explains
  static constexpr double kTravelTolerance = 0.5;  ///< of what its speed explains
  static constexpr double kReacceptTime =
      0.5;  ///< [s] after which new angles are taken as they are

  /// May these angles be acted upon? @param step [s] since the last look @param lost_leg that is
  /// not judged, -1: all are
  bool update(const LowState& state, double step, int lost_leg) noexcept {
    age_ += step;
    Vector12 q, travel;
    for (int i = 0; i < kMotors; ++i) {
      q[i] = state.motorState[i].q;
      travel[i] = state.motorState[i].dq * age_;
    }
    Vector12 error = (q - q_ - travel).cwiseAbs() - kTravelTolerance * travel.cwiseAbs();
    if (lost_leg >= 0) error.segment<kLegJoints>(kLegJoints * lost_leg).setZero();
    if (started_ && age_ < kReacceptTime && !(error.array() < kMaxJump).all()) return false;
    q_ = q;
    age_ = 0.0;
    started_ = true;
    return true;
  }

 private:
  Vector12 q_ = Vector12::Zero();  // [rad] that were last believed
  double age_ = 0.0;               // [s] of them
  bool started_ = false;
};

}  // namespace surefoot
