// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace surefoot {

/// Magnitude from which an entry of l or u means "no bound", as in ProxQP.
constexpr double kNoBound = 1e20;

/// Dense matrix in row-major storage, as ProxQP stores its data.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Quadratic program: minimise 1/2 x'H x + g'x subject to A x = b and l <= C x <= u.
struct QpProblem {
  /// Create a QP with n variables, n_eq equalities and n_in inequalities. All entries are zero.
  QpProblem(int n, int n_eq, int n_in)
      : H(RowMatrix::Zero(n, n)),
        g(Eigen::VectorXd::Zero(n)),
        A(RowMatrix::Zero(n_eq, n)),
        b(Eigen::VectorXd::Zero(n_eq)),
        C(RowMatrix::Zero(n_in, n)),
        l(Eigen::VectorXd::Zero(n_in)),
        u(Eigen::VectorXd::Zero(n_in)) {}
  RowMatrix H;        ///< matrix of the quadratic cost, shape (n, n), symmetric
  Eigen::VectorXd g;  ///< vector of the linear cost, shape (n,)
  RowMatrix A;        ///< matrix of the equalities, shape (n_eq, n)
  Eigen::VectorXd b;  ///< right-hand side of the equalities, shape (n_eq,)
  RowMatrix C;        ///< matrix of the inequalities, shape (n_in, n)
  Eigen::VectorXd l,  ///< lower bounds of C x, shape (n_in,); <= -kNoBound: no bound
      u;              ///< upper bounds of C x, shape (n_in,); >= kNoBound: no bound
};

}  // namespace surefoot
