// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Limits the rate of change of torques.
///
/// The torque changes of a leg are scaled by one factor, so that no torque changes faster than
/// kMaxRate, and the force of the foot changes straight towards the desired one. A leg whose
/// torques change much does not delay the others, for example when the power limit reduces their
/// torques. The sum of all forces does not change straight, then. A new damping Kd also changes the
/// torque of a motor, so the last torques are first converted to the new Kd. Real-time: yes.
class TorqueRateLimiter {
 public:
  /// [1/s] Largest rate of a torque, in tau_max per second: 9.5 % of tau_max in 2 ms, or 1100 N.m/s
  /// for the hips of a go1 (libfranka allows 1000 N.m/s). Derived: a little below the 10 % in 2 ms
  /// that `surefoot faults` allows. Without the limit, torques would change by up to 13 % in 2 ms,
  /// for two or three periods, after pushes of half of the largest survived impulse.
  static constexpr double kMaxRate = 47.5;

  explicit TorqueRateLimiter(const Vector12& tau_max) : tau_max_(tau_max) {}

  /// [s] limit() counts a longer period as this period: one period at 500 Hz. So after a missed
  /// tick no torque can jump further than in a usual tick.
  static constexpr double kMaxPeriod = 0.002;

  /// Limit the change of the torques since the last command.
  /// @param tau [N.m] in: desired; out: limited. The output is within +-tau_max if the input is
  /// @param kd damping that is sent with tau [N.m.s/rad]
  /// @param dq joint velocities [rad/s]
  /// @param period time between commands [s]
  /// @return whether tau was changed
  bool limit(Vector12& tau, const Vector12& kd, const Vector12& dq, double period) noexcept {
    const Vector12 last_equivalent = has_last_ ? equivalent_torques(kd, plausible_speeds(dq)) : tau;
    const Vector12 change = tau - last_equivalent;
    const double allowed = kMaxRate * std::min(period, kMaxPeriod);
    bool exceeds = false;
    for (int first = 0; first < kMotors; first += kLegJoints) {
      const Vector3 of_leg = change.segment<kLegJoints>(first);
      const double max_ratio =
          of_leg.cwiseQuotient(tau_max_.segment<kLegJoints>(first)).cwiseAbs().maxCoeff() / allowed;
      if (!(max_ratio > 1.0)) continue;
      exceeds = true;
      tau.segment<kLegJoints>(first) =
          last_equivalent.segment<kLegJoints>(first) + of_leg / max_ratio;
    }
    last_ = tau;
    kd_ = kd;
    has_last_ = true;
    dq_before_ = dq_;
    dq_ = dq;
    return exceeds;
  }
  /// Forget the last command, so that the next torques are not limited.
  void reset() noexcept {
    has_last_ = false;
    dq_ = dq_before_ = unknown();
  }
  /// Record that only damping was sent, with kd [N.m.s/rad] and no torques.
  void set_damping_only(double kd) noexcept {
    last_.setZero();
    kd_.setConstant(kd);
    has_last_ = true;
    dq_ = dq_before_ = unknown();
  }

 private:
  // [rad/s] Change of a velocity between two samples above which the velocity is wrong. Derived:
  // twice RunawayLegs::kMaxSpeedStep. Smaller than the wrong samples of 25 rad/s in the row
  // joint_speed of `surefoot faults`.
  static constexpr double kMaxSpeedStep = 10.0;
  static Vector12 unknown() noexcept { return Vector12::Constant(NAN); }

  /// Return the velocities, with each outlier replaced by the last velocity of its joint. An
  /// outlier differs by more than kMaxSpeedStep from both of the last two velocities of the joint.
  /// It is a sensor error, and would cause a torque jump when Kd changes during a fade.
  Vector12 plausible_speeds(const Vector12& dq) const noexcept {
    Vector12 out = dq;
    for (int i = 0; i < kMotors; ++i) {
      const bool is_outlier = std::abs(dq[i] - dq_[i]) > kMaxSpeedStep &&
                              std::abs(dq[i] - dq_before_[i]) > kMaxSpeedStep;
      if (is_outlier) out[i] = dq_[i];
    }
    return out;
  }
  /// Return the torques that, sent together with the damping `kd`, give the same motor torques as
  /// the last command. The result is limited to tau_max: torque plus damping of a motor cannot
  /// exceed this limit.
  Vector12 equivalent_torques(const Vector12& kd, const Vector12& dq) const noexcept {
    const Vector12 tau = last_ + (kd - kd_).cwiseProduct(dq);
    return tau.cwiseMax(-tau_max_).cwiseMin(tau_max_);
  }

  Vector12 tau_max_;
  Vector12 last_ = Vector12::Zero(), kd_ = Vector12::Zero();
  // [rad/s] Velocities of the last sample, and of the sample before it.
  Vector12 dq_ = unknown(), dq_before_ = unknown();
  bool has_last_ = false;  // true if last_ and kd_ hold the last command
};

}  // namespace surefoot
