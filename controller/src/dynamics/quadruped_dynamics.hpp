// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics_terms.hpp"
#include "dynamics/leg_pair_dynamics.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// The dynamics of a quadruped of Unitree's shape, by code generated from Pinocchio's algorithms.
///
/// The shape: a free base and four legs of hip x, thigh y, calf y, no placement turned. Lengths,
/// masses and inertias are data, so that own robots of that shape are served alike. The legs are
/// evaluated two at a time, one in each half of a vector register. Real-time: update() yes.
class QuadrupedDynamics {
 public:
  static bool fits(const Robot& robot) noexcept;

  /// @param robot one that fits()
  explicit QuadrupedDynamics(const Robot& robot);

  /// @param q shape (nq,), @param v shape (nv,), @param ground_normal unit, world axes
  void update(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const Vector3& ground_normal,
              DynamicsTerms& out) noexcept;

 private:
  void assemble_base(const Vector3& g_base, DynamicsTerms& out) const noexcept;

  LegPairDynamics legs_;
  double mass_;
  Vector3 gravity_;  ///< world axes [m/s^2]
  // The base's own body: mass, mass times centre, rotational inertia about the base's origin.
  double base_mass_;
  Vector3 base_mass_lever_;
  Matrix3 base_inertia_;
};

}  // namespace surefoot
