// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// How one robot gets up, worked out once.
///
/// From legs folded beside the lying body, knees up and feet behind the hips, to the standing pose
/// along a straight line in the joints, q(s) = folded + s (standing - folded). Legs that move alike
/// keep their feet at the same distances, so nothing slips while the body goes up and forward.
struct RisePlan {
  static constexpr int kSamples = 65;
  Vector12 folded = Vector12::Zero();    ///< [rad] s = 0: feet just above the ground
  Vector12 standing = Vector12::Zero();  ///< [rad] s = 1
  Vector12 wide = Vector12::Zero();      ///< [rad] hips turned outward, 0 elsewhere
  std::array<double, kSamples> rate{};   ///< [1/s] greatest ds/dt at s = k / (kSamples - 1)
  double stiffness = 0.0;                ///< [N.m/rad] of every joint on the way
  double damping = 0.0;                  ///< [N.m.s/rad]
  double torque_share = 0.0;             ///< greatest |tau| / tau_max that holding takes
  double time = 0.0;                     ///< [s] by the rates alone

  double rate_at(double s) const noexcept;
  Vector12 joints_at(double s) const noexcept { return folded + s * (standing - folded); }
};

/// Plan a rise whose motors take no more than a power, by the torques that hold the robot:
///   ds/dt <= watts / sum |tau_hold dq/ds|
/// and by a share of the joints' greatest speeds. Throws surefoot::Error for other than twelve
/// joints.
RisePlan plan_rise(const Robot& robot, double watts);

}  // namespace surefoot
