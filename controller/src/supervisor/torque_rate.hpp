// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Keeps torques from jumping: all motors' change is scaled down together, so that its direction
/// stays, until no motor changes faster than kRate of its limit. What a motor brakes less or more,
/// because its damping changes, is a change of torque, too. Real-time: yes.
class TorqueRate {
 public:
  /// [1/s] of tau_max: 0.095 in 2 ms, 1100 N.m/s on a go1's hips. Pushes of half of what it
  /// survives take up to 0.13, for two or three periods.
  static constexpr double kRate = 47.5;

  explicit TorqueRate(const Vector12& tau_max) : tau_max_(tau_max) {}

  /// [s] A longer period allows no more: motors see steps, however long they were let alone.
  static constexpr double kPeriod = 0.002;

  /// @param tau wanted, is what may be sent afterwards [N.m]; within +-tau_max if it was @param kd
  /// sent with it [N.m.s/rad] @param dq joint velocities [rad/s] @param period of commands [s]
  /// @return was it too much?
  bool limit(Vector12& tau, const Vector12& kd, const Vector12& dq, double period) noexcept {
    const Vector12 before = known_ ? goes_on(kd, believed(dq)) : tau;
    const Vector12 change = tau - before;
    const double allowed = kRate * std::min(period, kPeriod);
    const double most = change.cwiseQuotient(tau_max_).cwiseAbs().maxCoeff() / allowed;
    const bool jumps = most > 1.0;
    if (jumps) tau = before + change / most;
    last_ = tau;
    kd_ = kd;
    known_ = true;
    dq_before_ = dq_;
    dq_ = dq;
    return jumps;
  }
  /// What was sent last is not known: the next torques go as they are.
  void forget() noexcept {
    known_ = false;
    dq_ = dq_before_ = unknown();
  }
  /// The motors were told no torque: they damped by themselves, with kd [N.m.s/rad].
  void rest(double kd) noexcept {
    last_.setZero();
    kd_.setConstant(kd);
    known_ = true;
    dq_ = dq_before_ = unknown();
  }

 private:
  static constexpr double kLeap = 10.0;  // [rad/s] in a period: twice what a free leg can
  static Vector12 unknown() noexcept { return Vector12::Constant(NAN); }

  /// Speeds, but one that leaps from both of the last two is a lie, and the last one stands for it:
  /// where damping fades it would be a step of torque.
  Vector12 believed(const Vector12& dq) const noexcept {
    Vector12 out = dq;
    for (int i = 0; i < kMotors; ++i) {
      const bool leaps =
          std::abs(dq[i] - dq_[i]) > kLeap && std::abs(dq[i] - dq_before_[i]) > kLeap;
      if (leaps) out[i] = dq_[i];
    }
    return out;
  }
  /// What, sent with this damping, makes the motors make what they make. One that brakes at its
  /// limit makes no more than that, whatever its damping asks for.
  Vector12 goes_on(const Vector12& kd, const Vector12& dq) const noexcept {
    const Vector12 tau = last_ + (kd - kd_).cwiseProduct(dq);
    return tau.cwiseMax(-tau_max_).cwiseMin(tau_max_);
  }

  Vector12 tau_max_;
  Vector12 last_ = Vector12::Zero(), kd_ = Vector12::Zero();
  Vector12 dq_ = unknown(), dq_before_ = unknown();  // [rad/s] of the last two periods
  bool known_ = false;                               // are last_ and kd_ what was sent?
};

}  // namespace surefoot
