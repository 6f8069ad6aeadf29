// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

using Matrix63 = Eigen::Matrix<double, 6, 3>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// One leg's share of the equations of motion, and its contact point. World axes for points.
struct LegDynamics {
  Vector3 p_world_contact;   ///< [m] foot centre minus radius times ground normal
  Vector3 v_world_contact;   ///< [m/s] of the foot's material point there: zero when it rolls
  Vector3 w_world_shank;     ///< [rad/s] of the body that the foot belongs to
  Matrix3 joint_axes_world;  ///< columns: the leg's joint axes, about which the shank turns
  Matrix36 J_base;           ///< contact velocity from the base twist
  Matrix3 J_leg;             ///< contact velocity from the leg's three joint velocities
  Vector3 drift;             ///< [m/s^2] contact acceleration at zero generalised acceleration
  Matrix63 M_base_leg;       ///< block of the mass matrix
  Matrix3 M_leg;             ///< block of the mass matrix, armature included
  Vector3 h_leg;             ///< [N.m] Coriolis, centrifugal and gravity
  double depth;              ///< [m] of the foot below the hip axis, in the plane of the leg
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

/// What one tick needs of the robot as a whole, and of each leg.
struct DynamicsTerms {
  std::array<LegDynamics, kLegs> legs;
  Matrix6 M_base;  ///< block of the mass matrix
  Vector6 h_base;  ///< Coriolis, centrifugal and gravity
  Matrix3 R_world_base;
  Matrix3 I_world_com;  ///< all joints locked [kg.m^2]
  Vector3 p_world_com, v_world_com;
  Vector3 L_world_com;  ///< angular momentum about the centre of mass [kg.m^2/s]
  Vector3 p_world_base, v_world_base;
  Vector3 v_base, w_base;  ///< base axes
};

}  // namespace surefoot
