// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "safety/tick_clock.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Sees legs that their own torques fling: by how much the power rises that such a leg takes.
///
/// A leg whose foot slides off, or has lost the ground, takes within 15 ms what all four may. A
/// limit of what it takes now comes too late: it is known 5 ms later, and acts another 5 ms after.
/// Real-time: yes.
class RunawayLegs {
 public:
  /// Look at the joints, once a tick.
  /// @param dq shape (12,), motor order [rad/s] @param dt [s] since the last
  void update(const Vector12& dq, double dt) noexcept {
    // Over a longer gap, which is told as this one, nothing is known of what they do now; speeds
    // that leap there, and back in the next report, are a lie.
    const bool is_continuous = has_dq_ && dt > 0.0 && dt < TickClock::kMaxStep;
    if (is_continuous && (dq - dq_).cwiseAbs().maxCoeff() < kMaxSpeedStep) {
      ddq_ += dt / (dt + kSmoothingTime) * ((dq - dq_) / dt - ddq_);
    } else {
      ddq_.setZero();
    }
    dq_ = dq;
    has_dq_ = dq.allFinite();
  }
  /// [W] by which a leg's power rises within kLookahead if it goes on gathering speed, counting
  /// where its torques drive it, not where they brake.
  /// @param tau shape (12,), motor order, the motors' own damping included [N.m]
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
  static constexpr double kSmoothingTime = 0.002;  // [s] of the encoders' noise
  static constexpr double kMaxSpeedStep = 5.0;     // [rad/s] in a period: what a free leg can

  Vector12 dq_ = Vector12::Zero();   // [rad/s]
  Vector12 ddq_ = Vector12::Zero();  // [rad/s^2]
  bool has_dq_ = false;              // is dq_?
};

}  // namespace surefoot
