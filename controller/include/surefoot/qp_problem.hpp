// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace surefoot {

/// What l or u hold, at least, where there is no bound; ProxQP's own word for it.
constexpr double kNoBound = 1e20;

/// Row-major, as ProxQP stores its data.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A quadratic program: minimise 1/2 x'H x + g'x  subject to  A x = b,  l <= C x <= u
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
