// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "supervisor/leg_folding.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Torques of joints held by springs and dampers, on top of what gravity takes:
///   tau = tau_hold(load) + K (q_ref - q) + D dq_ref   and  - D dq  by the motors' own damping
/// with the spring's reach, the motors' limits and the power bounded. The damping is the motors'
/// because a leg that slips off the ground is let go of by a taut spring: what comes two or three
/// ticks later is too late for the power protection. Feet and body are weighed by joint
/// angles and the IMU's attitude alone. Real-time: yes.
class LegSprings {
 public:
  /// @param watts most that sum |tau dq| may be [W]
  LegSprings(const Robot& robot, const RisePlan& plan, double watts);

  /// Read joints and attitude out of a report.
  void read(const LowState& state) noexcept;
  const Vector12& q() const noexcept { return q_; }
  double damping() const noexcept { return damping_; }  ///< D, for the motors [N.m.s/rad]
  double cos_tilt() const noexcept { return cos_tilt_; }

  /// @param load share of the robot's weight that the feet bear, 0 .. 1
  /// @return shape (12,), SDK motor order [N.m]
  Vector12 torques(const JointReference& reference, double load) noexcept;

 private:
  Robot robot_;
  Dynamics dynamics_;
  RobotState state_;
  Vector12 q_ = Vector12::Zero(), dq_ = Vector12::Zero();
  double stiffness_, damping_, watts_;
  double cos_tilt_ = 1.0;
};

}  // namespace surefoot
