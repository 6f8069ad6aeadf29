// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/types.hpp"

namespace surefoot {

/// What l or u hold where there is no bound; ProxQP's own word for it.
constexpr double kNoBound = 1e20;

/// Row-major, as ProxQP stores its data.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// minimise 1/2 x'H x + g'x  subject to  l <= C x <= u
struct QpProblem {
  QpProblem(int n, int n_in)
      : H(RowMatrix::Zero(n, n)),
        g(Eigen::VectorXd::Zero(n)),
        C(RowMatrix::Zero(n_in, n)),
        l(Eigen::VectorXd::Zero(n_in)),
        u(Eigen::VectorXd::Zero(n_in)) {}
  RowMatrix H;
  Eigen::VectorXd g;
  RowMatrix C;
  Eigen::VectorXd l, u;
};

/// A program's answer as we checked it ourselves.
struct QpResult {
  Status status = Status::kWaiting;
  int iterations = 0;            ///< inner iterations
  double primal_residual = 0.0;  ///< greatest violation of l <= C x <= u
  double dual_residual = 0.0;    ///< greatest entry of H x + g + C'z
  double gap = 0.0;              ///< greatest |z_i| times row i's distance from its bound
};

/// ProxQP behind a small interface: fixed size, warm start, our own residual check.
///
/// The problem must come scaled (trace(H) = n, condition a few hundred at most): there is no
/// preconditioner. Real-time: solve() yes, allocates nothing.
class QpSolver {
 public:
  QpSolver(int n, int n_in);
  ~QpSolver();

  /// Solve, warm started from the last answer; go on from a corrected one while our check fails,
  /// and at last from nothing.
  QpResult solve(const QpProblem& problem) noexcept;

  /// Forget the last answer: the next solve starts cold.
  void reset() noexcept;

  const Eigen::VectorXd& x() const noexcept;
  const Eigen::VectorXd& z() const noexcept;  ///< multipliers of l <= C x <= u

 private:
  struct Workspace;
  void write(const QpProblem& problem) noexcept;
  QpResult run(const QpProblem& problem) noexcept;
  QpResult check(const QpProblem& problem) noexcept;
  double gap(Eigen::Index row) const noexcept;
  void drop_slack_multipliers() noexcept;
  void forget() noexcept;
  std::unique_ptr<Workspace> workspace_;
  bool has_answer_ = false;
};

}  // namespace surefoot
