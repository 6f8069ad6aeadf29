// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/qp_problem.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Outcome of a solve, with the residuals that QpCheck computed.
struct QpResult {
  Status status = Status::kWaiting;
  int iterations = 0;            ///< changes of the active set plus inner iterations of ProxQP
  double primal_residual = 0.0;  ///< largest violation of A x = b, l <= C x <= u
  double dual_residual = 0.0;    ///< largest |entry| of H x + g + A'y + C'z
  /// Largest min(|z_i|, 1) times the distance of row i of C x from u_i (z_i > 0) or l_i (z_i < 0).
  double gap = 0.0;
};

/// Whether a QP is known to have a solution.
enum class Feasibility { kCertain, kDoubtful };

/// Solver for QPs of one size: an active-set method first, ProxQP as fallback.
///
/// ActiveSet starts from the active constraints of the last solution. ProxQP solves the QP if
/// ActiveSet does not finish, or if its solution fails the residual check (QpCheck). The solutions
/// of both solvers must pass this check.
/// The QP must be scaled, because there is no preconditioner: trace(H) = n and a condition number
/// of at most a few hundred. Real-time: solve() yes, allocates nothing.
class QpSolver {
 public:
  /// @param tolerance tolerance of the residuals and of the gap. QpCheck accepts residuals up to 5
  ///   times as large
  QpSolver(int n, int n_eq, int n_in, double tolerance);
  /// @param max_changes largest number of changes of the active set before ProxQP takes over; with
  ///   0 ProxQP solves nearly all QPs
  QpSolver(int n, int n_eq, int n_in, double tolerance, int max_changes);
  ~QpSolver();

  /// Solve a QP, warm started from the last solution.
  ///
  /// If ProxQP's result fails the check, the next attempt starts from this result, with the
  /// multipliers of rows away from their bound set to zero. The fourth attempt is a cold start.
  /// @param budget number of inner iterations of ProxQP after which no further attempt begins
  /// @param feasibility kDoubtful: if ActiveSet finds contradicting constraints, the result is
  ///   kInfeasible. kCertain: a solution exists, so the contradiction is a rounding error, and
  ///   ProxQP solves the QP
  QpResult solve(const QpProblem& problem, int budget = kBudget,
                 Feasibility feasibility = Feasibility::kCertain) noexcept;
  /// Default budget, for callers without a deadline. One full attempt takes 96 inner iterations.
  /// ElasticSolver passes budgets of its own.
  static constexpr int kBudget = 100;

  /// Forget the last solution, so that the next solve is a cold start.
  void reset() noexcept;

  /// Start the next solve with the rows where z is nonzero as active set.
  void warm_start_from(const Eigen::VectorXd& z) noexcept;

  /// Set the tolerance for the next solves.
  void set_tolerance(double tolerance) noexcept;

  const Eigen::VectorXd& x() const noexcept;
  const Eigen::VectorXd& y() const noexcept;  ///< multipliers of A x = b
  const Eigen::VectorXd& z() const noexcept;  ///< multipliers of l <= C x <= u

 private:
  struct Workspace;
  QpResult try_active_set(const QpProblem& problem) noexcept;
  QpResult run_proxqp(const QpProblem& problem, int budget) noexcept;
  QpResult check(const QpProblem& problem) noexcept;
  void drop_inactive_multipliers(const QpProblem& problem) noexcept;
  void clear_solution() noexcept;
  std::unique_ptr<Workspace> workspace_;
  double tolerance_;
  int attempt_factor_;
  bool has_solution_ = false;
};

}  // namespace surefoot
