// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

using Matrix63 = Eigen::Matrix<double, 6, 3>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// Terms of one leg in the equations of motion, and its contact point. Positions, velocities and
/// accelerations of the contact point are in world axes.
struct LegDynamics {
  Vector3 p_world_contact;  ///< [m] foot centre minus radius times ground normal
  /// [m/s] Velocity of the foot's material point at the contact; zero if the foot rolls without
  /// slip.
  Vector3 v_world_contact;
  /// [rad/s] Angular velocity of the shank, the body to which the foot belongs.
  Vector3 w_world_shank;
  Matrix3 joint_axes_world;  ///< columns: axes of the leg's joints
  Matrix36 J_base;           ///< Jacobian from the base twist (base axes) to the contact velocity
  Matrix3 J_leg;             ///< Jacobian from the leg's joint velocities to the contact velocity
  /// [m/s^2] Acceleration of the contact point at zero generalised acceleration, for a constant
  /// ground normal n: a_centre + r n x alpha_shank.
  Vector3 drift;
  Matrix63 M_base_leg;  ///< block of the mass matrix: base rows, columns of the leg
  Matrix3 M_leg;        ///< block of the mass matrix, learnt armature included
  /// [N.m] Coriolis, centrifugal and gravity torques, and joint friction (Dynamics::set_joints()).
  Vector3 h_leg;
  /// [m] Depth of the contact point below the hip axis, in the leg's plane. Dynamics makes it
  /// positive in the standing pose.
  double depth;
};

/// Full matrices of the equations of motion, for a model of any shape.
struct FullDynamics {
  explicit FullDynamics(int nv)
      : M(Eigen::MatrixXd::Zero(nv, nv)),
        h(Eigen::VectorXd::Zero(nv)),
        J(Eigen::MatrixXd::Zero(3 * kLegs, nv)) {}
  Eigen::MatrixXd M;  ///< mass matrix, learnt armature included
  Eigen::VectorXd h;  ///< Coriolis, centrifugal and gravity forces, and joint friction
  Eigen::MatrixXd J;  ///< contact Jacobian, rows FR FL RR RL
};

/// Terms of the whole robot and of each leg in one tick.
struct DynamicsTerms {
  std::array<LegDynamics, kLegs> legs;
  Matrix6 M_base;  ///< block of the mass matrix: rows and columns of the base
  Vector6 h_base;  ///< [N], [N.m] Coriolis, centrifugal and gravity forces, base axes
  Matrix3 R_world_base;
  Matrix3 I_world_com;  ///< [kg.m^2] inertia about the centre of mass, all joints locked
  Vector3 p_world_com, v_world_com;    ///< [m], [m/s]
  Vector3 L_world_com;                 ///< [kg.m^2/s] angular momentum about the centre of mass
  Vector3 p_world_base, v_world_base;  ///< [m], [m/s]
  Vector3 v_base, w_base;              ///< [m/s], [rad/s] base axes, as passed to update()
};

}  // namespace surefoot
