// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Rise plan: the path of one robot from lying to standing, computed once.
///
/// The path is a parabola in joint space with parameter s = 0 .. 1:
///   q(s) = (1 - s)^2 folded + 2 s (1 - s) crouched + s^2 standing
/// folded: legs beside the lying body, knees up, feet behind the hips. crouched: calves still
/// folded, feet below the hips; the path passes near this pose, not through it. The path bends
/// towards `crouched`, so that the body is above its feet before it rises. On a straight line the
/// body would be ahead of its feet for half of the path, and would tip forward with a load or on a
/// downward slope. All legs move alike, so the distances between the feet stay constant and no foot
/// slips.
struct RisePlan {
  /// Number of samples of s: 64 equal steps from 0 to 1.
  static constexpr int kSamples = 65;
  Vector12 folded = Vector12::Zero();    ///< [rad] s = 0: feet just above the ground
  Vector12 crouched = Vector12::Zero();  ///< [rad] pose towards which the path bends
  Vector12 standing = Vector12::Zero();  ///< [rad] s = 1: the standing pose
  /// [rad] Hip angles of legs that are turned outward while they fold. Signed: negative at right
  /// legs. Other joints: 0.
  Vector12 hip_outward = Vector12::Zero();
  /// [rad] Outward joint limits of the hips, less a margin. Signed: negative at right legs. Other
  /// joints: 0.
  Vector12 hip_outward_limit = Vector12::Zero();
  Vector12 lower = Vector12::Zero();    ///< [rad] lower joint limits plus a margin
  Vector12 upper = Vector12::Zero();    ///< [rad] upper joint limits minus a margin
  std::array<double, kSamples> rate{};  ///< [1/s] limit of ds/dt at s = k / (kSamples - 1)
  double stiffness = 0.0;               ///< [N.m/rad] K of JointImpedance, the same for all joints
  double damping = 0.0;  ///< [N.m.s/rad] D of JointImpedance, the same for all joints
  /// Largest holding torque on the path, as a share of tau_max. The robot can rise only if it is
  /// below 1.
  double max_holding_share = 0.0;
  /// [s] Duration from folded to standing if ds/dt is always at its limit: without acceleration and
  /// braking.
  double time = 0.0;

  /// Return the limit of ds/dt at s [1/s], interpolated between samples.
  double rate_at(double s) const noexcept;
  /// Return q(s) [rad].
  Vector12 joints_at(double s) const noexcept {
    const double r = 1.0 - s;
    return r * r * folded + 2.0 * s * r * crouched + s * s * standing;
  }
  /// Return dq/ds [rad].
  Vector12 direction_at(double s) const noexcept {
    return 2.0 * (1.0 - s) * (crouched - folded) + 2.0 * s * (standing - crouched);
  }
  /// Return s of the path sample nearest to the given joint angles [rad].
  double nearest(const Vector12& joints) const noexcept;
};

/// Plan a rise. The limit of ds/dt keeps the power of the holding torques below `watts` [W],
///   ds/dt <= watts / sum |tau_hold dq/ds|,
/// and the joint velocities below a share of their limits. Throw surefoot::Error if the robot does
/// not have twelve joints.
RisePlan plan_rise(const Robot& robot, double watts);

}  // namespace surefoot
