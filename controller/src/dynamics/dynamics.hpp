// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>

#include "surefoot/robot.hpp"

namespace surefoot {

using Matrix63 = Eigen::Matrix<double, 6, 3>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// One leg's share of the equations of motion, and its contact point. World axes for points.
struct LegDynamics {
  Vector3 p_world_contact;  ///< [m] foot centre minus radius times ground normal
  Vector3 v_world_contact;  ///< [m/s] of the foot's material point there: zero when it rolls
  Matrix36 J_base;          ///< contact velocity from the base twist
  Matrix3 J_leg;            ///< contact velocity from the leg's three joint velocities
  Vector3 drift;            ///< [m/s^2] contact acceleration at zero generalised acceleration
  Matrix63 M_base_leg;      ///< block of the mass matrix
  Matrix3 M_leg;            ///< block of the mass matrix, armature included
  Vector3 h_leg;            ///< [N.m] Coriolis, centrifugal and gravity
  double depth;             ///< [m] of the foot below the hip axis, in the plane of the leg
};

/// The same for a model of any shape, for the general form.
struct FullDynamics {
  explicit FullDynamics(int nv)
      : M(Eigen::MatrixXd::Zero(nv, nv)),
        h(Eigen::VectorXd::Zero(nv)),
        J(Eigen::MatrixXd::Zero(3 * kLegs, nv)) {}
  Eigen::MatrixXd M;  ///< mass matrix, armature included
  Eigen::VectorXd h;  ///< Coriolis, centrifugal and gravity
  Eigen::MatrixXd J;  ///< contact velocities FR FL RR RL from v
};

/// Everything Pinocchio computes in one tick; the only caller of its algorithms.
///
/// Base quantities are in base axes, as Pinocchio's v is. The contact rows are those of a sphere
/// that rolls on the ground: J = J_centre + [r n]x J_angular, so that no friction force is needed
/// to let the shank turn about the foot. Real-time: update() yes.
class Dynamics {
 public:
  explicit Dynamics(const Robot& robot);
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

  const std::array<LegDynamics, kLegs>& legs() const noexcept { return legs_; }
  /// Rotational inertia about the centre of mass with all joints locked, world axes [kg.m^2].
  const Matrix3& I_world_com() const noexcept { return I_world_com_; }
  const Matrix6& M_base() const noexcept { return M_base_; }
  const Vector6& h_base() const noexcept { return h_base_; }
  const Matrix3& R_world_base() const noexcept { return R_world_base_; }
  const Vector3& p_world_com() const noexcept { return p_world_com_; }
  const Vector3& v_world_com() const noexcept { return v_world_com_; }
  /// What shift() adds to the base's linear spatial acceleration: -w x v, base axes [m/s^2].
  const Vector3& a_base_shift() const noexcept { return a_base_shift_; }
  Vector3 w_world_base() const noexcept { return R_world_base_ * w_base_; }
  const Vector3& w_base() const noexcept { return w_base_; }
  const Vector3& p_world_base() const noexcept { return p_world_base_; }
  const Vector3& v_world_base() const noexcept { return v_world_base_; }
  /// Base velocity that update() was given, base axes [m/s]: M and h belong to this one.
  const Vector3& v_base() const noexcept { return v_base_; }
  /// Angular momentum about the centre of mass, world axes [kg.m^2/s].
  const Vector3& L_world_com() const noexcept { return L_world_com_; }

 private:
  void update_leg(int leg, const Vector3& ground_normal) noexcept;
  void update_com(const Eigen::VectorXd& v) noexcept;
  void update_depth(int leg) noexcept;
  bool has_chains_of_three() const noexcept;

  struct Pinocchio;
  std::unique_ptr<Pinocchio> pinocchio_;
  Robot robot_;
  std::array<LegDynamics, kLegs> legs_;
  Matrix6 M_base_;
  Vector6 h_base_;
  Matrix3 R_world_base_, I_world_com_;
  Vector3 p_world_com_, v_world_com_, L_world_com_, w_base_, v_base_, a_base_shift_;
  Vector3 p_world_base_, v_world_base_;
  bool condensable_;
  std::array<double, kLegs> depth_sign_{1.0, 1.0, 1.0, 1.0};
};

}  // namespace surefoot
