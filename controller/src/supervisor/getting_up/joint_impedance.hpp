// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Joint impedance of a robot that rises or sits: springs and dampers in addition to gravity
/// torques,
///   tau = tau_hold(load) + K (q_ref - q) + D dq_ref,   plus   -D dq   from the motors' damping.
/// tau_hold depends only on joint angles and the IMU's attitude. `load` is the share of the robot's
/// weight on the feet.
///
/// Damping: the motor drivers compute the torque -D dq (Kd = D). When a leg slips off the ground,
/// its spring accelerates the leg at once. If the command contained the damping torque, this torque
/// would act two or three ticks later, and the power protection would trip first.
///
/// Limits: spring deflection, torques and power are limited. The damping alone may take more than
/// the power limit, for example in a leg that comes free from under the body. Then the commanded
/// torques counteract a part of the damping. A body that rolls off a leg drives the joints faster
/// than torques can change. So the damping is reduced while the body rolls or pitches fast
/// (reduce_damping()). With less damping, the spring of a leg that comes free takes more power, so
/// limit_power_when_free() then reduces the spring torques of lying legs too. Real-time: yes.
class JointImpedance {
 public:
  /// @param watts limit of the power sum |tau dq| [W]
  JointImpedance(const Robot& robot, const RisePlan& plan, double watts);

  /// Read joints and attitude from a sample.
  void read(const LowState& state) noexcept;
  const Vector12& q() const noexcept { return q_; }  ///< [rad] measured angles, SDK motor order
  /// Reduce the damping while the body rolls or pitches fast, and restore it when the body is slow.
  /// @param angular_speed norm of the body's angular velocity [rad/s]; 0 if the body does not lie
  /// @param dt time since the last call [s]
  void reduce_damping(double angular_speed, double dt) noexcept;
  double damping() const noexcept { return damping_; }  ///< D, to be sent to the motors [N.m.s/rad]
  const Quaternion& R_world_base() const noexcept { return R_world_base_; }
  /// Return the world's vertical in base axes, unit length.
  Vector3 up() const noexcept { return R_world_base_.conjugate() * Vector3::UnitZ(); }
  const Quaternion& R_base_imu() const noexcept { return R_base_imu_; }
  /// Set the usable share of each motor's torque, 0 .. 1, SDK motor order.
  void set_torque_share(const Vector12& share) noexcept { torque_share_ = share; }

  /// Compute the torques that are to be sent together with damping().
  /// @param load share of the robot's weight on the feet, 0 .. 1
  /// @return shape (12,), SDK motor order [N.m]
  Vector12 torques(const JointReference& reference, double load) noexcept;
  /// Compute the torques that hold only the weight of the legs in the last pose that was read,
  /// shape (12,), SDK motor order [N.m].
  Vector12 leg_gravity_torques() noexcept;
  /// Return whether the motors can hold the whole robot in the last pose that was read.
  bool can_hold() noexcept;
  /// Estimate the share of the robot's weight on the legs, about 0 .. 1. The torques beyond
  /// leg_gravity_torques() are projected onto the torques of a full load on four legs.
  /// @param measured joint torques, SDK motor order [N.m]
  double load_share(const Vector12& measured) noexcept;

 private:
  Vector12 gravity_torques(double load) noexcept;
  /// Return the spring deflections [rad], scaled so that all springs together stay within the power
  /// limit even if all legs come free from an obstacle at once.
  Vector12 limit_power_when_free(const Vector12& deflection) const noexcept;

  Robot robot_;
  Dynamics dynamics_;
  RobotState state_;  // pose of the last sample, base at the origin and at rest
  Vector12 q_ = Vector12::Zero(), dq_ = Vector12::Zero();
  double stiffness_, full_damping_, damping_, power_limit_;
  Vector12 torque_share_ = Vector12::Ones();
  Quaternion R_world_base_ = Quaternion::Identity(), R_base_imu_ = Quaternion::Identity();
};

}  // namespace surefoot
