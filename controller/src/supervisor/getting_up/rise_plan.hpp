// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// How one robot gets up, worked out once.
///
/// From legs folded beside the lying body, knees up and feet behind the hips, over a crouch with
/// the calves still folded and the feet below the hips, to the standing pose: a parabola in the
/// joints,
///   q(s) = (1 - s)^2 folded + 2 s (1 - s) crouched + s^2 standing
/// that bends towards the crouch, for the body to come over its feet before it is up. (A straight
/// line keeps it ahead of them on half of the way: with a load, or down a slope, it tips forward.)
/// Legs that move alike keep their feet at the same distances, so nothing slips.
struct RisePlan {
  static constexpr int kSamples = 65;
  Vector12 folded = Vector12::Zero();       ///< [rad] s = 0: feet just above the ground
  Vector12 crouched = Vector12::Zero();     ///< [rad] what the way bends towards
  Vector12 standing = Vector12::Zero();     ///< [rad] s = 1
  Vector12 hip_outward = Vector12::Zero();  ///< [rad] hips turned outward, 0 elsewhere
  Vector12 hip_outward_max =
      Vector12::Zero();                 ///< [rad] hips outward as far as they go, 0 elsewhere
  Vector12 lower = Vector12::Zero();    ///< [rad] the joints' ends, with a little kept from them
  Vector12 upper = Vector12::Zero();    ///< [rad]
  std::array<double, kSamples> rate{};  ///< [1/s] greatest ds/dt at s = k / (kSamples - 1)
  double stiffness = 0.0;               ///< [N.m/rad] of every joint on the way
  double damping = 0.0;                 ///< [N.m.s/rad]
  double torque_share = 0.0;            ///< greatest |tau| / tau_max that holding takes
  double time = 0.0;                    ///< [s] by the rates alone

  double rate_at(double s) const noexcept;
  Vector12 joints_at(double s) const noexcept {
    const double r = 1.0 - s;
    return r * r * folded + 2.0 * s * r * crouched + s * s * standing;
  }
  /// dq/ds [rad].
  Vector12 direction_at(double s) const noexcept {
    return 2.0 * (1.0 - s) * (crouched - folded) + 2.0 * s * (standing - crouched);
  }
  /// s of the sample whose joints are the nearest.
  double nearest(const Vector12& joints) const noexcept;
};

/// Plan a rise whose motors take no more than a power, by the torques that hold the robot:
///   ds/dt <= watts / sum |tau_hold dq/ds|
/// and by a share of the joints' greatest speeds. Throws surefoot::Error for other than twelve
/// joints.
RisePlan plan_rise(const Robot& robot, double watts);

}  // namespace surefoot
