// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// The equations of motion as functions of the contact forces f alone.
///
/// With three joints per leg and point feet, the foot accelerations a_f and the base acceleration
/// a_b determine the leg accelerations a_l:
///   legs:    a_l = W_l a_b + w_l,   W_l = -J_l^-1 J_b,   w_l = J_l^-1 (a_f - drift)
///   base:    (M_bb + sum M_bl W_l) a_b + sum M_bl w_l + h_b = J_b^T f + wrench
///            =>   a_b = B f + c
///   joints:  tau = T f + t0
/// The equations of motion and the contact accelerations therefore hold for any f.
/// docs/explanation/condensed-qp.md has the derivation.
struct Condensed {
  Matrix6x12 B;  ///< base acceleration per newton of contact force (FR FL RR RL, world axes)
  Vector6 c;     ///< base acceleration at zero contact forces
  Matrix12 T;    ///< joint torques (SDK motor order) per newton of contact force
  Vector12 t0;   ///< joint torques at zero contact forces [N.m]
  Eigen::Matrix<double, 12, 6> W;  ///< leg accelerations (SDK motor order) per base acceleration
  Vector12 w;                      ///< leg accelerations at zero base acceleration [rad/s^2]

  /// Return the leg accelerations (SDK motor order) [rad/s^2] for a base acceleration.
  Vector12 leg_accelerations(const Vector6& a_base) const noexcept { return W * a_base + w; }
};

/// Compute the condensed equations of motion.
/// @param feet_acceleration desired contact accelerations, world axes [m/s^2]
/// @param external_wrench external wrench on the base about its origin, base axes [N], [N.m];
///   `wrench` in the equations above
/// @param smallest_determinant [m^3] a leg with a smaller |det J| counts as singular
/// @param out out: the condensed equations; only partly written if the result is false
/// @return false if a leg is singular: its foot is near hip height, or its knee is nearly straight
/// Real-time: yes.
bool condense(const Dynamics& dynamics, const FeetMatrix& feet_acceleration,
              const Vector6& external_wrench, double smallest_determinant, Condensed& out) noexcept;

}  // namespace surefoot
