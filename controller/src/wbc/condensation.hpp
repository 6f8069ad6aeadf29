// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// The equations of motion with everything but the contact forces eliminated.
///
/// With three joints a leg and point feet, foot accelerations a_f and the base's a_b fix the legs':
///   legs:    a_l = W_l a_b + w_l,   W_l = -J_l^-1 J_b,   w_l = J_l^-1 (a_f - drift)
///   base:    (M_bb + sum M_bl W_l) a_b + sum M_bl w_l + h_b = J_b^T f   =>   a_b = B f + c
///   joints:  tau = T f + t0
/// so dynamics and contacts hold by construction whatever f is. Derived in docs/condensed-qp.md.
struct Condensed {
  Matrix6x12 B;  ///< base acceleration from forces; forces FR FL RR RL, world axes [N]
  Vector6 c;
  Matrix12 T;  ///< joint torques (SDK motor order) from forces
  Vector12 t0;
  Eigen::Matrix<double, 12, 6> W;  ///< leg accelerations (SDK motor order) from the base's
  Vector12 w;

  /// Leg accelerations (SDK motor order) that go with a base acceleration.
  Vector12 leg_accelerations(const Vector6& a_base) const noexcept { return W * a_base + w; }
};

/// Eliminate; false when a leg is singular (foot near hip height, or leg straight).
/// @param feet_acceleration desired contact accelerations, world axes [m/s^2]
/// @param smallest_determinant of a leg's Jacobian [m^3] that may still be inverted
/// @param external_wrench on the base from neither joints nor feet, base axes [N], [N.m]
/// Real-time: yes.
bool condense(const Dynamics& dynamics, const FeetMatrix& feet_acceleration,
              const Vector6& external_wrench, double smallest_determinant, Condensed& out) noexcept;

}  // namespace surefoot
