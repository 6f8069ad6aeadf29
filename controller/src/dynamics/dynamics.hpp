// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "dynamics/dynamics_terms.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

class PinocchioDynamics;
class QuadrupedDynamics;

/// Kinematics and dynamics of the robot in one tick: M dv/dt + h = S^T tau + J^T f.
///
/// Generated code computes all terms for a robot of Unitree's shape (QuadrupedDynamics); Pinocchio
/// computes them for other robots. Quantities with `_world` in their name, and the contact
/// quantities of the legs, are in world axes. Other base quantities are in base axes, as in
/// Pinocchio's v.
///
/// The contact Jacobian describes a sphere of radius r that rolls on ground with normal n:
/// J = J_centre + [r n]x J_angular, where [a]x is the matrix of the cross product a x. So the shank
/// can rotate about the foot without a friction force. Real-time: update() yes.
class Dynamics {
 public:
  enum class Source { kAuto, kPinocchio };  ///< kPinocchio: only for tests that compare both
  explicit Dynamics(const Robot& robot, Source source = Source::kAuto);
  ~Dynamics();
  Dynamics(Dynamics&&) noexcept;

  /// Set the learnt errors of the joints, RobotState::armature_error, joint_damping and
  /// joint_friction, which update() adds to the mass matrix and to h. Initially 0. Real-time: yes.
  void set_joints(const RobotState& state) noexcept;

  /// Compute all terms at a state.
  /// @param q configuration, shape (nq,)
  /// @param v velocity, shape (nv,)
  /// @param ground_normal unit length, world axes
  void update(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
              const Vector3& ground_normal) noexcept;

  /// Shift the results to another inertial frame. There the position of the base is larger by
  /// p_world [m], and its linear velocity by v_world [m/s], world axes.
  ///
  /// The estimator calls update() before it knows position and velocity of the base, with the base
  /// at the origin and without linear velocity. The equations of motion do not depend on the
  /// inertial frame. So shift() only changes points, their velocities and a_base_shift(); v_base()
  /// does not change.
  void shift(const Vector3& p_world, const Vector3& v_world) noexcept;

  /// Joint friction that h contains [N.m], SDK motor order; see set_joints().
  const Vector12& friction_torque() const noexcept { return friction_torque_; }

  /// Return whether the model is a free base with four chains of three joints and nothing else. The
  /// condensed form of the QP is valid only for such a model.
  bool condensable() const noexcept { return condensable_; }
  /// Write the full matrices, which the general form needs. Real-time: yes.
  void write_full(FullDynamics& out) const noexcept;

  /// Return whether generated code computes the dynamics of this robot.
  bool uses_generated_code() const noexcept { return quadruped_ != nullptr; }

  const std::array<LegDynamics, kLegs>& legs() const noexcept { return terms_.legs; }
  /// Rotational inertia about the centre of mass with all joints locked, world axes [kg.m^2].
  const Matrix3& I_world_com() const noexcept { return terms_.I_world_com; }
  const Matrix6& M_base() const noexcept { return terms_.M_base; }
  const Vector6& h_base() const noexcept { return terms_.h_base; }
  const Matrix3& R_world_base() const noexcept { return terms_.R_world_base; }
  const Vector3& p_world_com() const noexcept { return terms_.p_world_com; }
  const Vector3& v_world_com() const noexcept { return terms_.v_world_com; }
  /// Amount by which shift() changed the linear spatial acceleration of the base, base axes
  /// [m/s^2]: -w x v, where v is the velocity that was passed to shift().
  const Vector3& a_base_shift() const noexcept { return a_base_shift_; }
  Vector3 w_world_base() const noexcept { return terms_.R_world_base * terms_.w_base; }
  const Vector3& w_base() const noexcept { return terms_.w_base; }
  const Vector3& p_world_base() const noexcept { return terms_.p_world_base; }
  const Vector3& v_world_base() const noexcept { return terms_.v_world_base; }
  /// Linear velocity of the base that was passed to update(), base axes [m/s]. h_base() and h_leg
  /// are valid for this velocity. shift() does not change v_base(): after shift() the actual
  /// velocity is v_world_base().
  const Vector3& v_base() const noexcept { return terms_.v_base; }
  /// Angular momentum about the centre of mass, world axes [kg.m^2/s].
  const Vector3& L_world_com() const noexcept { return terms_.L_world_com; }

 private:
  Robot robot_;
  std::unique_ptr<QuadrupedDynamics> quadruped_;  ///< null if the robot has another shape
  std::unique_ptr<PinocchioDynamics> pinocchio_;  ///< null if quadruped_ is used
  DynamicsTerms terms_;
  // See set_joints().
  Vector12 armature_error_ = Vector12::Zero(), damping_ = Vector12::Zero(),
           friction_ = Vector12::Zero();
  Vector12 friction_torque_ = Vector12::Zero();  // [N.m] at the velocity of update()
  Vector3 a_base_shift_;
  bool condensable_;
  std::array<double, kLegs> depth_sign_{1.0, 1.0, 1.0, 1.0};  // see LegDynamics::depth
};

/// Return the contact points FR FL RR RL, world frame [m]. Real-time: yes.
inline FeetMatrix contact_points(const Dynamics& dynamics) noexcept {
  FeetMatrix points;
  for (int leg = 0; leg < kLegs; ++leg) points.col(leg) = dynamics.legs()[leg].p_world_contact;
  return points;
}

/// Compute the velocities of the contact points when the spherical feet roll without slip:
/// w_world_shank x lever, times the contact confidence. Real-time: yes.
/// @param contact contact confidence per foot, 0 .. 1
/// @param lever vector from a contact point to the centre of its foot, world axes [m]
/// @return velocities FR FL RR RL, world axes [m/s]
inline FeetMatrix rolling_velocities(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                                     const Vector3& lever) noexcept {
  FeetMatrix velocities;
  for (int leg = 0; leg < kLegs; ++leg) {
    velocities.col(leg) = contact[leg] * dynamics.legs()[leg].w_world_shank.cross(lever);
  }
  return velocities;
}

}  // namespace surefoot
