// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "safety/tick_clock.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detector of runaway legs: predicts how much the power of a leg will rise.
///
/// A leg whose foot slips off or loses contact can, within 15 ms, take as much power as is allowed
/// for all four legs. A limit on the measured power would act too late, because the power is
/// measured 5 ms late and the command acts another 5 ms later. So the class extrapolates the joint
/// velocities by 15 ms. Real-time: yes.
class RunawayLegs {
 public:
  /// Update the joint accelerations; call it once per tick.
  /// @param dq joint velocities, shape (12,), motor order [rad/s]
  /// @param dt time since the last call [s]
  void update(const Vector12& dq, double dt) noexcept {
    // Over a time step of kMaxStep or more the acceleration is unknown; TickClock returns kMaxStep
    // for a confirmed jump. A change of velocity by kMaxSpeedStep or more is a sensor error.
    const bool is_continuous = has_dq_ && dt > 0.0 && dt < TickClock::kMaxStep;
    if (is_continuous && (dq - dq_).cwiseAbs().maxCoeff() < kMaxSpeedStep) {
      ddq_ += dt / (dt + kSmoothingTime) * ((dq - dq_) / dt - ddq_);
    } else {
      ddq_.setZero();
    }
    dq_ = dq;
    has_dq_ = dq.allFinite();
  }
  /// Return how much the power of a leg will rise within kLookahead at its present joint
  /// accelerations [W]. Only power that drives a joint counts, not power that brakes a joint.
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
  // [s] Time over which joint velocities are extrapolated. Measured with pushed go2s (git de2557d):
  // within this time the power of a runaway leg reaches the power allowed for four legs. A longer
  // time would also limit landings.
  static constexpr double kLookahead = 0.015;
  // [s] Time constant of the filter against encoder noise. Derived: one period at 500 Hz.
  static constexpr double kSmoothingTime = 0.002;
  // [rad/s] Change of a joint velocity in one period from which the velocity is wrong. Chosen
  // larger than the 0.8 rad/s by which the velocity of a runaway leg changed in 2 ms (400 rad/s^2),
  // and smaller than the error of a wrong sample. Test: test_runaway_legs.cpp.
  static constexpr double kMaxSpeedStep = 5.0;

  Vector12 dq_ = Vector12::Zero();   // [rad/s]
  Vector12 ddq_ = Vector12::Zero();  // [rad/s^2]
  bool has_dq_ = false;              // true if dq_ is valid
};

}  // namespace surefoot
