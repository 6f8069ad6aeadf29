// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/condensation.hpp"

#include <Eigen/LU>

#include "surefoot/stage_clock.hpp"

namespace surefoot {

bool condense(const Dynamics& dynamics, const FeetMatrix& feet_acceleration,
              const Vector6& external_wrench, double smallest_determinant,
              Condensed& out) noexcept {
  const StageScope stage(Stage::kCondense);
  Matrix6 A = dynamics.M_base();
  Vector6 r = dynamics.h_base() - external_wrench;
  Matrix6x12 base_wrench_from_force;

  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    Matrix3 inverse;
    bool invertible = false;
    L.J_leg.computeInverseWithCheck(inverse, invertible, smallest_determinant);
    if (!invertible) return false;
    const Matrix36 W = -inverse * L.J_base;
    const Vector3 w = inverse * (feet_acceleration.col(leg) - L.drift);
    A.noalias() += L.M_base_leg * W;
    r.noalias() += L.M_base_leg * w;
    base_wrench_from_force.middleCols<3>(3 * leg) = L.J_base.transpose();
    out.W.middleRows<3>(3 * leg) = W;
    out.w.segment<3>(3 * leg) = w;
  }

  const Eigen::PartialPivLU<Matrix6> lu(A);
  out.B = lu.solve(base_wrench_from_force);
  out.c = -lu.solve(r);

  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const int row = 3 * leg;
    // tau = M_lb a_b + M_ll a_l + h_l - J_l^T f
    const Matrix36 G = L.M_base_leg.transpose() + L.M_leg * out.W.middleRows<3>(row);
    out.T.middleRows<3>(row).noalias() = G * out.B;
    out.T.block<3, 3>(row, row) -= L.J_leg.transpose();
    out.t0.segment<3>(row) = G * out.c + L.M_leg * out.w.segment<3>(row) + L.h_leg;
  }
  return true;
}

}  // namespace surefoot
