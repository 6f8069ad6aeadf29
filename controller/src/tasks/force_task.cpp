// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/force_task.hpp"

#include <Eigen/Cholesky>

namespace surefoot {

Vector12 even_forces(const TaskRows& first, const TaskRows& second,
                     const Eigen::Vector4d& share) noexcept {
  Matrix6x12 A;
  A << first.A, second.A;
  Vector6 b;
  b << first.b, second.b;
  // Rows of one length: angular rows are some ten times longer than the centre of mass's.
  for (int i = 0; i < 6; ++i) {
    const double scale = 1.0 / A.row(i).norm();
    A.row(i) *= scale;
    b[i] *= scale;
  }
  Matrix6x12 A_share = A;
  for (int leg = 0; leg < kLegs; ++leg) A_share.middleCols<3>(3 * leg) *= share[leg];
  Matrix6 gram = A_share * A.transpose();
  // Two feet leave a direction without authority; a little damping keeps the answer finite there.
  gram.diagonal().array() += 1e-9;
  return A_share.transpose() * gram.ldlt().solve(b);
}

}  // namespace surefoot
