// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace surefoot {

/// Bounds of at least this magnitude in l or u mean "no bound", as in ProxQP.
constexpr double kNoBound = 1e20;

/// Dense matrix in row-major storage, as ProxQP stores its data.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Quadratic program: minimise 1/2 x'H x + g'x  subject to  A x = b,  l <= C x <= u
///
/// Shapes: H (n, n) symmetric, g (n,), A (n_eq, n), b (n_eq,), C (n_in, n), l and u (n_in,).
struct QpProblem {
  QpProblem(int n, int n_eq, int n_in)
      : H(RowMatrix::Zero(n, n)),
        g(Eigen::VectorXd::Zero(n)),
        A(RowMatrix::Zero(n_eq, n)),
        b(Eigen::VectorXd::Zero(n_eq)),
        C(RowMatrix::Zero(n_in, n)),
        l(Eigen::VectorXd::Zero(n_in)),
        u(Eigen::VectorXd::Zero(n_in)) {}
  RowMatrix H;
  Eigen::VectorXd g;
  RowMatrix A;
  Eigen::VectorXd b;
  RowMatrix C;
  Eigen::VectorXd l, u;
};

}  // namespace surefoot
