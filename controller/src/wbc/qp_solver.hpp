// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/qp_problem.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// A program's answer as we checked it ourselves.
struct QpResult {
  Status status = Status::kWaiting;
  int iterations = 0;            ///< changes of active rows, and inner iterations of ProxQP
  double primal_residual = 0.0;  ///< greatest violation of A x = b, l <= C x <= u
  double dual_residual = 0.0;    ///< greatest entry of H x + g + A'y + C'z
  double gap = 0.0;              ///< greatest min(|z_i|, 1) times row i's distance from its bound
};

/// Is a program known to have an answer?
enum class Feasibility { kCertain, kDoubtful };

/// An active-set method with ProxQP behind it, behind a small interface: fixed size, warm start,
/// our own residual check of either's answer.
///
/// A program is tried by the rows that were active last (ActiveSet); where that does not end or our
/// check fails, ProxQP solves it.
/// The problem must come scaled (trace(H) = n, condition a few hundred at most): there is no
/// preconditioner. Real-time: solve() yes, allocates nothing.
class QpSolver {
 public:
  /// @param tolerance of the residuals; what is accepted is 5 times that
  QpSolver(int n, int n_eq, int n_in, double tolerance);
  /// @param max_changes of the active rows before ProxQP takes over; 0: nearly always
  QpSolver(int n, int n_eq, int n_in, double tolerance, int max_changes);
  ~QpSolver();

  /// Solve, warm started from the last answer; go on from a corrected one while our check fails,
  /// and at last from nothing.
  /// @param budget ProxQP's inner iterations after which it begins no further attempt
  /// @param feasibility doubtful: rows that contradict each other end the solve with kInfeasible at
  ///   once; certain: they can only be rounding, and ProxQP goes on
  QpResult solve(const QpProblem& problem, int budget = kBudget,
                 Feasibility feasibility = Feasibility::kCertain) noexcept;
  static constexpr int kBudget = 100;

  /// Forget the last answer: the next solve starts cold.
  void reset() noexcept;

  /// Take the rows where z is not zero for active when the next solve starts.
  void warm_start_from(const Eigen::VectorXd& z) noexcept;

  /// Ask for this from the next solve on.
  void set_tolerance(double tolerance) noexcept;

  const Eigen::VectorXd& x() const noexcept;
  const Eigen::VectorXd& y() const noexcept;  ///< multipliers of A x = b
  const Eigen::VectorXd& z() const noexcept;  ///< multipliers of l <= C x <= u

 private:
  struct Workspace;
  QpResult try_active_set(const QpProblem& problem) noexcept;
  QpResult run_proxqp(const QpProblem& problem, int budget) noexcept;
  QpResult check(const QpProblem& problem) noexcept;
  void drop_slack_multipliers(const QpProblem& problem) noexcept;
  void clear_answer() noexcept;
  std::unique_ptr<Workspace> workspace_;
  double tolerance_;
  int attempt_factor_;
  bool has_answer_ = false;
};

}  // namespace surefoot
