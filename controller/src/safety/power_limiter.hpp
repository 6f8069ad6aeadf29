// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Torques within a power, and what that took.
struct LimitedTorques {
  Vector12 torques = Vector12::Zero();  ///< [N.m]
  double scale = 1.0;                   ///< s, 0 .. 1: how much of the wanted motion is left
  double power = 0.0;                   ///< [W] sum |tau dq| of what the motors then make
  bool limit_exceeded = false;          ///< no s is within the limit
};

/// [W] sum |(tau - damping dq) dq|: what motors take. All shapes (12,). Real-time: yes.
inline double power_of(const Vector12& tau, const Vector12& dq, double damping) noexcept {
  return (tau - damping * dq).cwiseProduct(dq).cwiseAbs().sum();
}

/// Scale torques about those that hold the robot still, until they are within a power.
///
///   tau(s) = hold + s (tau - hold)    P(s) = sum over i of |(tau_i(s) - damping dq_i) dq_i|
///
/// with the greatest s in [0, 1] for which P(s) <= limit. P is convex, so below that s it may rise
/// again, above it never falls. Where no s is within the limit: s = 0, the holding torques. Where
/// any number is none: the same, with 0 for the holding torques that are none.
/// @param tau wanted @param hold against gravity; both shape (12,) [N.m]
/// @param dq joint velocities, the same order [rad/s] @param limit [W]; may be infinite
/// @param damping [N.m.s/rad] that the motors add to the torques by themselves
/// Real-time: yes.
LimitedTorques limit_power(const Vector12& tau, const Vector12& hold, const Vector12& dq,
                           double limit, double damping = 0.0) noexcept;

}  // namespace surefoot
