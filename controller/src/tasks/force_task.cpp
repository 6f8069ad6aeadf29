// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/force_task.hpp"

#include <Eigen/Cholesky>

namespace surefoot {

Vector12 even_forces(const Dynamics& dynamics, const Vector3& force, const Vector3& moment,
                     const Eigen::Vector4d& share) noexcept {
  Eigen::Matrix<double, 6, 12> A;
  double arm_squared = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 arm = dynamics.legs()[leg].p_world_contact - dynamics.p_world_com();
    A.block<3, 3>(0, 3 * leg).setIdentity();
    A.block<3, 3>(3, 3 * leg) = skew(arm);
    arm_squared += arm.squaredNorm() / kLegs;
  }
  // Rows of one length, whatever the size of the robot.
  const double scale = 1.0 / std::sqrt(arm_squared);
  A.bottomRows<3>() *= scale;
  Vector6 b;
  b << force, scale * moment;
  Eigen::Matrix<double, 6, 12> A_share = A;
  for (int leg = 0; leg < kLegs; ++leg) A_share.middleCols<3>(3 * leg) *= share[leg];
  Matrix6 gram = A_share * A.transpose();
  // Two feet leave a direction without authority; a little damping keeps the answer finite there.
  gram.diagonal().array() += 1e-9;
  return A_share.transpose() * gram.ldlt().solve(b);
}

Vector3 turning_moment(const Dynamics& dynamics, const Vector3& alpha_world) noexcept {
  const Matrix3& I = dynamics.I_world_com();
  const Vector3 w = dynamics.w_world_base();
  return I * alpha_world + w.cross(I * w);
}

}  // namespace surefoot
