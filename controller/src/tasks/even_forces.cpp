// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/even_forces.hpp"

#include <Eigen/Cholesky>

namespace surefoot {

Vector12 even_forces(const Matrix6x12& A, const Vector6& b, const Eigen::Vector4d& share) noexcept {
  // Scale the rows to length one, because they have different units.
  const Vector6 scale = A.rowwise().norm().cwiseInverse();
  const Matrix6x12 rows = scale.asDiagonal() * A;
  Matrix6x12 weighted_rows = rows;
  for (int leg = 0; leg < kLegs; ++leg) weighted_rows.middleCols<3>(3 * leg) *= share[leg];
  Matrix6 gram = weighted_rows * rows.transpose();
  // Forces at two feet produce no moment about the line between them, so `gram` can be singular.
  // The damping keeps the result finite. Numerical: the rows have length one, so a damping of 1e-9
  // causes an error below the QP's tolerance of 1e-6.
  gram.diagonal().array() += 1e-9;
  return weighted_rows.transpose() * gram.ldlt().solve(scale.cwiseProduct(b));
}

Vector12 even_forces(const Dynamics& dynamics, const Vector3& force, const Vector3& moment,
                     const Eigen::Vector4d& share) noexcept {
  Matrix6x12 A;
  for (int leg = 0; leg < kLegs; ++leg) {
    A.block<3, 3>(0, 3 * leg).setIdentity();
    A.block<3, 3>(3, 3 * leg) = skew(dynamics.legs()[leg].p_world_contact - dynamics.p_world_com());
  }
  Vector6 b;
  b << force, moment;
  return even_forces(A, b, share);
}

Vector3 turning_moment(const Dynamics& dynamics, const Vector3& alpha_world) noexcept {
  const Matrix3& I = dynamics.I_world_com();
  const Vector3 w = dynamics.w_world_base();
  return I * alpha_world + w.cross(I * w);
}

}  // namespace surefoot
