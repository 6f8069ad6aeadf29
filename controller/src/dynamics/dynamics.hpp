// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "dynamics/dynamics_terms.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

class PinocchioDynamics;
class QuadrupedDynamics;

/// The robot's dynamics in one tick: from generated code where the robot has the shape that it is
/// for (QuadrupedDynamics), else from Pinocchio.
///
/// Base quantities are in base axes, as Pinocchio's v is. The contact rows are those of a sphere
/// that rolls on the ground: J = J_centre + [r n]x J_angular, so that no friction force is needed
/// to let the shank turn about the foot. Real-time: update() yes.
class Dynamics {
 public:
  enum class Source { kAuto, kPinocchio };  ///< the second for tests: one against the other
  explicit Dynamics(const Robot& robot, Source source = Source::kAuto);
  ~Dynamics();
  Dynamics(Dynamics&&) noexcept;

  /// @param q shape (nq,), @param v shape (nv,), @param ground_normal unit, world axes
  void update(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
              const Vector3& ground_normal) noexcept;

  /// Move the results to an inertial frame in which the base has this extra position and velocity.
  ///
  /// update() may be run with the base at the origin and at rest, before either is known; the
  /// equations of motion do not change with the inertial frame, so only points and velocities move.
  void shift(const Vector3& p_world, const Vector3& v_world) noexcept;

  /// Is the model a free base with four chains of three joints and nothing else? Only then does
  /// the condensed form hold.
  bool condensable() const noexcept { return condensable_; }
  /// Copy out what the general form needs. Real-time: yes.
  void write_full(FullDynamics& out) const noexcept;

  /// Does the generated code serve this robot?
  bool uses_generated_code() const noexcept { return quadruped_ != nullptr; }

  const std::array<LegDynamics, kLegs>& legs() const noexcept { return terms_.legs; }
  /// Rotational inertia about the centre of mass with all joints locked, world axes [kg.m^2].
  const Matrix3& I_world_com() const noexcept { return terms_.I_world_com; }
  const Matrix6& M_base() const noexcept { return terms_.M_base; }
  const Vector6& h_base() const noexcept { return terms_.h_base; }
  const Matrix3& R_world_base() const noexcept { return terms_.R_world_base; }
  const Vector3& p_world_com() const noexcept { return terms_.p_world_com; }
  const Vector3& v_world_com() const noexcept { return terms_.v_world_com; }
  /// What shift() adds to the base's linear spatial acceleration: -w x v, base axes [m/s^2].
  const Vector3& a_base_shift() const noexcept { return a_base_shift_; }
  Vector3 w_world_base() const noexcept { return terms_.R_world_base * terms_.w_base; }
  const Vector3& w_base() const noexcept { return terms_.w_base; }
  const Vector3& p_world_base() const noexcept { return terms_.p_world_base; }
  const Vector3& v_world_base() const noexcept { return terms_.v_world_base; }
  /// Base velocity that update() was given, base axes [m/s]: M and h belong to this one.
  const Vector3& v_base() const noexcept { return terms_.v_base; }
  /// Angular momentum about the centre of mass, world axes [kg.m^2/s].
  const Vector3& L_world_com() const noexcept { return terms_.L_world_com; }

 private:
  Robot robot_;
  std::unique_ptr<QuadrupedDynamics> quadruped_;  ///< null: the robot has another shape
  std::unique_ptr<PinocchioDynamics> pinocchio_;  ///< null: not needed
  DynamicsTerms terms_;
  Vector3 a_base_shift_;
  bool condensable_;
  std::array<double, kLegs> depth_sign_{1.0, 1.0, 1.0, 1.0};
};

/// Contact points, shape (3, 4) [m], world axes. Real-time: yes.
inline FeetMatrix contact_points(const Dynamics& dynamics) noexcept {
  FeetMatrix points;
  for (int leg = 0; leg < kLegs; ++leg) points.col(leg) = dynamics.legs()[leg].p_world_contact;
  return points;
}

/// How fast contact points move as their ball feet roll: w x lever, of those that bear. Shape (3,
/// 4) [m/s], world axes; the contact point moves so though nothing slips.
/// @param contact belief per foot, 0 .. 1
/// @param lever [m] from a contact point to its foot's centre, world axes. Real-time: yes.
inline FeetMatrix rolling_velocities(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                                     const Vector3& lever) noexcept {
  FeetMatrix rates;
  for (int leg = 0; leg < kLegs; ++leg) {
    rates.col(leg) = contact[leg] * dynamics.legs()[leg].w_world_shank.cross(lever);
  }
  return rates;
}

}  // namespace surefoot
