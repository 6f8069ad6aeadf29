// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

using Matrix63 = Eigen::Matrix<double, 6, 3>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

/// Terms of one leg in the equations of motion, and its contact point. Contact quantities are in
/// world axes.
struct LegDynamics {
  Vector3 p_world_contact;   ///< [m] foot centre minus radius times ground normal
  Vector3 v_world_contact;   ///< [m/s] of the foot's material point there; zero in rolling
  Vector3 w_world_shank;     ///< [rad/s] of the body that has the foot
  Matrix3 joint_axes_world;  ///< columns: joint axes of the leg
  Matrix36 J_base;           ///< contact velocity from the base twist
  Matrix3 J_leg;             ///< contact velocity from the leg's three joint velocities
  Vector3 drift;             ///< [m/s^2] contact acceleration at zero generalised acceleration
  Matrix63 M_base_leg;       ///< block of the mass matrix
  Matrix3 M_leg;             ///< block of the mass matrix, armature included
  Vector3 h_leg;             ///< [N.m] Coriolis, centrifugal and gravity
  double depth;              ///< [m] of the foot below the hip axis, in the leg's plane
};

/// Full matrices of the equations of motion, for a model of any shape.
struct FullDynamics {
  explicit FullDynamics(int nv)
      : M(Eigen::MatrixXd::Zero(nv, nv)),
        h(Eigen::VectorXd::Zero(nv)),
        J(Eigen::MatrixXd::Zero(3 * kLegs, nv)) {}
  Eigen::MatrixXd M;  ///< mass matrix, armature included
  Eigen::VectorXd h;  ///< Coriolis, centrifugal and gravity
  Eigen::MatrixXd J;  ///< contact Jacobian, rows FR FL RR RL
};

/// Terms of the whole robot and of each leg in one tick.
struct DynamicsTerms {
  std::array<LegDynamics, kLegs> legs;
  Matrix6 M_base;  ///< block of the mass matrix
  Vector6 h_base;  ///< Coriolis, centrifugal and gravity
  Matrix3 R_world_base;
  Matrix3 I_world_com;                 ///< all joints locked [kg.m^2]
  Vector3 p_world_com, v_world_com;    ///< [m], [m/s]
  Vector3 L_world_com;                 ///< angular momentum about the centre of mass [kg.m^2/s]
  Vector3 p_world_base, v_world_base;  ///< [m], [m/s]
  Vector3 v_base, w_base;              ///< [m/s], [rad/s] base axes
};

}  // namespace surefoot
