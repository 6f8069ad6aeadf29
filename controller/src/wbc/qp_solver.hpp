// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/qp_problem.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// A program's answer as we checked it ourselves.
struct QpResult {
  Status status = Status::kWaiting;
  int iterations = 0;            ///< active set steps, and ProxQP's inner iterations
  double primal_residual = 0.0;  ///< greatest violation of A x = b, l <= C x <= u
  double dual_residual = 0.0;    ///< greatest entry of H x + g + A'y + C'z
  double gap = 0.0;              ///< greatest min(|z_i|, 1) times row i's distance from its bound
};

/// ProxQP behind a small interface: fixed size, warm start, our own residual check. Before it is
/// asked, a few steps of an active set method are tried: as long as the rows on their bounds stay
/// nearly those of the last answer, one of them passes the check and ProxQP is not run at all.
///
/// The problem must come scaled (trace(H) = n, condition a few hundred at most): there is no
/// preconditioner. Real-time: solve() yes, allocates nothing.
class QpSolver {
 public:
  /// @param tolerance of the residuals; what is accepted is 5 times that
  QpSolver(int n, int n_eq, int n_in, double tolerance);
  ~QpSolver();

  /// Solve, warm started from the last answer; go on from a corrected one while our check fails,
  /// and at last from nothing.
  /// @param budget inner iterations of ProxQP after which no further attempt begins
  QpResult solve(const QpProblem& problem, int budget = kBudget) noexcept;
  static constexpr int kBudget = 100;

  /// Forget the last answer: the next solve starts cold.
  void reset() noexcept;

  /// Ask for this from the next solve on.
  void set_tolerance(double tolerance) noexcept;

  const Eigen::VectorXd& x() const noexcept;
  const Eigen::VectorXd& y() const noexcept;  ///< multipliers of A x = b
  const Eigen::VectorXd& z() const noexcept;  ///< multipliers of l <= C x <= u

 private:
  struct Workspace;
  void write(const QpProblem& problem) noexcept;
  QpResult try_steps(const QpProblem& problem) noexcept;
  QpResult run_proxqp(const QpProblem& problem, int budget) noexcept;
  QpResult run(const QpProblem& problem) noexcept;
  void drop_slack_multipliers(const QpProblem& problem) noexcept;
  void forget() noexcept;
  std::unique_ptr<Workspace> workspace_;
  double tolerance_;
  int patience_;
  bool has_answer_ = false;
};

}  // namespace surefoot
