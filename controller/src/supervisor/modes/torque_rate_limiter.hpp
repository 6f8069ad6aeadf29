// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Limits the rate of change of torques.
///
/// All motors' changes are scaled by one factor, so that no motor changes faster than kMaxRate and
/// the direction of the change is kept. A new damping Kd of a motor also changes its torque. So the
/// last torques are first converted to the new Kd. Real-time: yes.
class TorqueRateLimiter {
 public:
  /// [tau_max/s] Largest rate of a torque: 9.5 % of tau_max in 2 ms, or 1100 N.m/s for the hips of
  /// a go1 (libfranka: 1000). Derived: 5 % below the rate of 10 % in 2 ms that `surefoot faults`
  /// allows. Pushes at half of the largest survived impulse need up to 13 %, for two or three
  /// periods.
  static constexpr double kMaxRate = 47.5;

  explicit TorqueRateLimiter(const Vector12& tau_max) : tau_max_(tau_max) {}

  /// [s] Longest period over which a torque may change: one period at 500 Hz. With a longer one a
  /// motor would see a larger step.
  static constexpr double kMaxPeriod = 0.002;

  /// Limit the change of the torques since the last command.
  /// @param tau in: desired; out: limited, within +-tau_max if it was before [N.m]
  /// @param kd damping sent with tau [N.m.s/rad] @param dq joint velocities [rad/s]
  /// @param period between commands [s]
  /// @return whether tau was changed
  bool limit(Vector12& tau, const Vector12& kd, const Vector12& dq, double period) noexcept {
    const Vector12 before = has_last_ ? equivalent_torques(kd, plausible_speeds(dq)) : tau;
    const Vector12 change = tau - before;
    const double allowed = kMaxRate * std::min(period, kMaxPeriod);
    const double max_ratio = change.cwiseQuotient(tau_max_).cwiseAbs().maxCoeff() / allowed;
    const bool exceeds = max_ratio > 1.0;
    if (exceeds) tau = before + change / max_ratio;
    last_ = tau;
    kd_ = kd;
    has_last_ = true;
    dq_before_ = dq_;
    dq_ = dq;
    return exceeds;
  }
  /// Forget the last command: the next torques pass unlimited.
  void reset() noexcept {
    has_last_ = false;
    dq_ = dq_before_ = unknown();
  }
  /// Record that damping alone was sent, with kd [N.m.s/rad] and no torques.
  void set_damping_only(double kd) noexcept {
    last_.setZero();
    kd_.setConstant(kd);
    has_last_ = true;
    dq_ = dq_before_ = unknown();
  }

 private:
  // [rad/s] Change of velocity between two samples above which the velocity is wrong. Derived:
  // twice the step of a free leg (RunawayLegs::kMaxSpeedStep). Must be below the wrong samples of
  // 25 rad/s in the row joint_speed of `surefoot faults`.
  static constexpr double kMaxSpeedStep = 10.0;
  static Vector12 unknown() noexcept { return Vector12::Constant(NAN); }

  /// Return the velocities, with each outlier replaced by the last velocity of its joint. An
  /// outlier differs by more than kMaxSpeedStep from both of the last two velocities; it is a
  /// sensor error. While damping fades, it would cause a step of torque.
  Vector12 plausible_speeds(const Vector12& dq) const noexcept {
    Vector12 out = dq;
    for (int i = 0; i < kMotors; ++i) {
      const bool leaps = std::abs(dq[i] - dq_[i]) > kMaxSpeedStep &&
                         std::abs(dq[i] - dq_before_[i]) > kMaxSpeedStep;
      if (leaps) out[i] = dq_[i];
    }
    return out;
  }
  /// Return the torques that, sent with damping `kd`, give the same motor torques as the last
  /// command. They are clamped, because a motor that brakes at its limit gives no more torque.
  Vector12 equivalent_torques(const Vector12& kd, const Vector12& dq) const noexcept {
    const Vector12 tau = last_ + (kd - kd_).cwiseProduct(dq);
    return tau.cwiseMax(-tau_max_).cwiseMin(tau_max_);
  }

  Vector12 tau_max_;
  Vector12 last_ = Vector12::Zero(), kd_ = Vector12::Zero();
  Vector12 dq_ = unknown(), dq_before_ = unknown();  // [rad/s] of the last two samples
  bool has_last_ = false;                            // whether last_ and kd_ hold the last command
};

}  // namespace surefoot
