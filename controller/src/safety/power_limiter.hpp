// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Torques within a power limit, and the scale that limited them.
struct LimitedTorques {
  Vector12 torques = Vector12::Zero();  ///< [N.m]
  double scale = 1.0;                   ///< s of limit_power(); 1: desired, 0: holding torques
  double swing_scale = 1.0;             ///< s of the swing legs, see TorqueCommand
  std::array<bool, kLegs> swings{};     ///< legs that have swing_scale
  double power = 0.0;                   ///< [W] power of these torques, see power_of()
  /// True if the power exceeds the limit for every s in [0, 1], or if a number is not finite.
  bool no_scale_within_limit = false;
};

/// Compute the power of the motors [W], sum |(tau - damping dq) dq|. tau and dq: shape (12,).
/// Real-time: yes.
inline double power_of(const Vector12& tau, const Vector12& dq, double damping) noexcept {
  return (tau - damping * dq).cwiseProduct(dq).cwiseAbs().sum();
}

/// Scale torques towards the holding torques until their power is within a limit.
///
///   tau(s) = hold + s (tau - hold)    P(s) = sum over i of |(tau_i(s) - damping dq_i) dq_i|
///
/// The result has the largest s in [0, 1] with P(s) <= limit. P is convex, so it never falls above
/// the s with the smallest power. If no s satisfies the limit, s is 0: the result is the holding
/// torques. If a number is not finite, s is 0 too, and holding torques that are not finite are set
/// to 0. Real-time: yes.
/// @param tau desired torques, shape (12,) [N.m]
/// @param hold holding torques: they hold the robot against gravity, shape (12,) [N.m]
/// @param dq joint velocities, in the same order as the torques [rad/s]
/// @param limit largest power [W]; may be infinite
/// @param damping motor-side damping added to the torques [N.m.s/rad]
LimitedTorques limit_power(const Vector12& tau, const Vector12& hold, const Vector12& dq,
                           double limit, double damping = 0.0) noexcept;

}  // namespace surefoot
