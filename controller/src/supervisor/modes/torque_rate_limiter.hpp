// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Keeps torques from jumping: all motors' change is scaled down together, so that its direction
/// stays, until no motor changes faster than kMaxRate of its limit. What a motor brakes less or
/// more, because its damping changes, is a change of torque, too. Real-time: yes.
class TorqueRateLimiter {
 public:
  /// [1/s] of tau_max: 0.095 in 2 ms, 1100 N.m/s on a go1's hips. Pushes of half of what it
  /// survives take up to 0.13, for two or three periods.
  static constexpr double kMaxRate = 47.5;

  explicit TorqueRateLimiter(const Vector12& tau_max) : tau_max_(tau_max) {}

  /// [s] A longer period allows no more: motors see steps, however long they were let alone.
  static constexpr double kMaxPeriod = 0.002;

  /// @param tau wanted, is what may be sent afterwards [N.m]; within +-tau_max if it was @param kd
  /// sent with it [N.m.s/rad] @param dq joint velocities [rad/s] @param period of commands [s]
  /// @return was it too much?
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
  /// What was sent last is not known: the next torques go as they are.
  void reset() noexcept {
    has_last_ = false;
    dq_ = dq_before_ = unknown();
  }
  /// The motors were told no torque: they damped by themselves, with kd [N.m.s/rad].
  void set_damping_only(double kd) noexcept {
    last_.setZero();
    kd_.setConstant(kd);
    has_last_ = true;
    dq_ = dq_before_ = unknown();
  }

 private:
  static constexpr double kMaxSpeedStep = 10.0;  // [rad/s] in a period: twice what a free leg can
  static Vector12 unknown() noexcept { return Vector12::Constant(NAN); }

  /// Speeds, but one that leaps from both of the last two is a lie, and the last one stands for it:
  /// where damping fades it would be a step of torque.
  Vector12 plausible_speeds(const Vector12& dq) const noexcept {
    Vector12 out = dq;
    for (int i = 0; i < kMotors; ++i) {
      const bool leaps = std::abs(dq[i] - dq_[i]) > kMaxSpeedStep &&
                         std::abs(dq[i] - dq_before_[i]) > kMaxSpeedStep;
      if (leaps) out[i] = dq_[i];
    }
    return out;
  }
  /// What, sent with this damping, makes the motors make what they make. One that brakes at its
  /// limit makes no more than that, whatever its damping asks for.
  Vector12 equivalent_torques(const Vector12& kd, const Vector12& dq) const noexcept {
    const Vector12 tau = last_ + (kd - kd_).cwiseProduct(dq);
    return tau.cwiseMax(-tau_max_).cwiseMin(tau_max_);
  }

  Vector12 tau_max_;
  Vector12 last_ = Vector12::Zero(), kd_ = Vector12::Zero();
  Vector12 dq_ = unknown(), dq_before_ = unknown();  // [rad/s] of the last two periods
  bool has_last_ = false;                            // are last_ and kd_ what was sent?
};

}  // namespace surefoot
