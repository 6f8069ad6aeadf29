// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics_terms.hpp"
#include "dynamics/leg_pair_dynamics.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Dynamics of a quadruped of Unitree's shape, computed by code generated from Pinocchio's
/// algorithms.
///
/// Such a robot has a free base and four legs with joint axes x (hip), y (thigh), y (calf), without
/// rotated joint placements. Lengths, masses and inertias are data, so any robot of this shape can
/// be used. Two legs are evaluated at a time, one in each half of a vector register. Real-time:
/// update() yes.
class QuadrupedDynamics {
 public:
  /// Return whether the robot has the shape described above.
  static bool fits(const Robot& robot) noexcept;

  /// @param robot must satisfy fits()
  explicit QuadrupedDynamics(const Robot& robot);

  /// Compute all terms at a state.
  /// @param q configuration, shape (nq,)
  /// @param v velocity, shape (nv,)
  /// @param ground_normal unit length, world axes
  void update(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const Vector3& ground_normal,
              DynamicsTerms& out) noexcept;

 private:
  void assemble_base(const Vector3& g_base, DynamicsTerms& out) const noexcept;

  LegPairDynamics legs_;
  double mass_;
  Vector3 gravity_;  ///< world axes [m/s^2]
  // Base body: mass [kg], mass times centre of mass [kg.m], rotational inertia about the base
  // origin [kg.m^2].
  double base_mass_;
  Vector3 base_mass_lever_;
  Matrix3 base_inertia_;
};

}  // namespace surefoot
