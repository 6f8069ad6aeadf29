// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Torques of joints held by springs and dampers, on top of what gravity takes:
///   tau = tau_hold(load) + K (q_ref - q) + D dq_ref   and  - D dq  by the motors' own damping
/// with the spring's reach, the motors' limits and the power bounded. The damping is the motors'
/// because a leg that slips off the ground is let go of by a taut spring: what comes two or three
/// ticks later is too late for the power protection. Where braking alone takes more than the power
/// allows, torques take some of it back: a leg that comes free from under the body is flung,
/// whatever the springs do. A body that falls onto its legs, as it rolls off one, drives them
/// faster than torques can change: while it turns they brake less beforehand, and where it tumbles
/// they pull less, for its fall's end drives all joints at once. Feet and body are weighed by joint
/// angles and the IMU's attitude alone. Real-time: yes.
class JointImpedance {
 public:
  /// @param watts most that sum |tau dq| may be [W]
  JointImpedance(const Robot& robot, const RisePlan& plan, double watts);

  /// Read joints and attitude out of a report.
  void read(const LowState& state) noexcept;
  const Vector12& q() const noexcept { return q_; }
  /// Brake less while the body turns, and pull less while it tumbles.
  /// @param turn_rate how fast [rad/s] @param dt [s]
  void reduce_damping(double turn_rate, double dt) noexcept;
  double damping() const noexcept { return damping_; }  ///< D, for the motors [N.m.s/rad]
  const Quaternion& R_world_base() const noexcept { return R_world_base_; }
  /// The world's vertical, in base axes.
  Vector3 up() const noexcept { return R_world_base_.conjugate() * Vector3::UnitZ(); }
  const Quaternion& R_base_imu() const noexcept { return R_base_imu_; }
  /// Share of each motor's torque that may be used, SDK order.
  void set_torque_share(const Vector12& share) noexcept { torque_share_ = share; }

  /// @param load share of the robot's weight that the feet bear, 0 .. 1
  /// @return shape (12,), SDK motor order [N.m]
  Vector12 torques(const JointReference& reference, double load) noexcept;
  /// Torques that bear the legs alone in the pose read, shape (12,), SDK motor order [N.m].
  Vector12 leg_gravity_torques() noexcept;
  /// Can the motors hold the whole robot in the pose read?
  bool can_hold() noexcept;
  /// Share of the robot's weight that the legs bear by the torques measured, about 0 .. 1.
  double load_share(const Vector12& measured) noexcept;

 private:
  Vector12 gravity_torques(double load) noexcept;
  /// Less pull [rad], so that all springs that come free at once stay within the power.
  Vector12 limit_released_power(const Vector12& pull) const noexcept;

  Robot robot_;
  Dynamics dynamics_;
  RobotState state_;
  Vector12 q_ = Vector12::Zero(), dq_ = Vector12::Zero();
  double stiffness_, full_damping_, damping_, power_limit_;
  Vector12 torque_share_ = Vector12::Ones();
  Quaternion R_world_base_ = Quaternion::Identity(), R_base_imu_ = Quaternion::Identity();
};

}  // namespace surefoot
