// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "safety/tick_clock.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detector of runaway legs: predicts how much the power of a leg will rise.
///
/// A leg whose foot slips off or loses contact can take the power allowed for all four legs within
/// 15 ms. A limit on its present power acts too late: the power is measured 5 ms late, and the
/// command acts another 5 ms later. So the joint velocities are extrapolated. Real-time: yes.
class RunawayLegs {
 public:
  /// Update the joint accelerations; call it once per tick.
  /// @param dq joint velocities, shape (12,), motor order [rad/s]
  /// @param dt time since the last call [s]
  void update(const Vector12& dq, double dt) noexcept {
    // A dt of kMaxStep may stand for a longer gap, over which the acceleration is unknown. A larger
    // jump of a velocity is a sensor error.
    const bool is_continuous = has_dq_ && dt > 0.0 && dt < TickClock::kMaxStep;
    if (is_continuous && (dq - dq_).cwiseAbs().maxCoeff() < kMaxSpeedStep) {
      ddq_ += dt / (dt + kSmoothingTime) * ((dq - dq_) / dt - ddq_);
    } else {
      ddq_.setZero();
    }
    dq_ = dq;
    has_dq_ = dq.allFinite();
  }
  /// Compute by how much the power of a leg rises within kLookahead at its present acceleration
  /// [W]. Only power that drives a joint counts, not power that brakes it.
  /// @param tau torques, shape (12,), motor order, motor-side damping included [N.m]
  double power_rise(const Vector12& tau, int leg) const noexcept {
    double watts = 0.0;
    for (int i = kLegJoints * leg; i < kLegJoints * (leg + 1); ++i) {
      const double power_now = std::max(0.0, tau[i] * dq_[i]);
      watts += std::max(0.0, tau[i] * (dq_[i] + kLookahead * ddq_[i]) - power_now);
    }
    return watts;
  }
  void reset() noexcept { *this = {}; }

 private:
  static constexpr double kLookahead = 0.015;      // [s]
  static constexpr double kSmoothingTime = 0.002;  // [s] filters the encoders' noise
  static constexpr double kMaxSpeedStep = 5.0;  // [rad/s] largest change of a free leg per period

  Vector12 dq_ = Vector12::Zero();   // [rad/s]
  Vector12 ddq_ = Vector12::Zero();  // [rad/s^2]
  bool has_dq_ = false;              // true if dq_ is valid
};

}  // namespace surefoot
