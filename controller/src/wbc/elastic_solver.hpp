// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wbc/qp_solver.hpp"

namespace surefoot {

/// Assignment of the rows of C to groups; the elastic rows of a group share one slack.
struct ElasticRows {
  int groups = 0;          ///< number of groups
  std::vector<int> group;  ///< for each row of C: its group, or -1 if the row is hard
};

/// Solver for QPs with elastic constraints, which may be violated at a penalty:
///   minimise    1/2 x'H x + g'x + sum_k (penalty_k s_k + 1/2 curvature s_k^2)
///   subject to  A x = b,   l - s <= C x <= u + s,   s >= 0
/// The rows of group k share the slack s_k; hard rows have no slack. The elastic QP is feasible
/// whenever its hard constraints are feasible.
///
/// The penalty is linear and therefore exact (Nocedal and Wright 2006, thm. 17.3). The hard QP is
/// the QP without slacks. If the sum of the |multipliers| of each group k is at most penalty_k, the
/// solution of the hard QP also solves the elastic QP, with s = 0. So the solver first solves the
/// hard QP, which is smaller. It solves the elastic QP only if the hard QP is infeasible or one of
/// these sums exceeds its penalty. While a slack is nonzero or the elastic QP fails, and until ten
/// solves without slack have followed, the solver solves the elastic QP alone. Real-time: solve()
/// yes.
class ElasticSolver {
 public:
  ElasticSolver(int n, int n_eq, const ElasticRows& rows, double tolerance);

  /// Set the tolerance for the next solves.
  void set_tolerance(double tolerance) noexcept {
    hard_solver_.set_tolerance(tolerance);
    elastic_solver_.set_tolerance(tolerance);
  }

  /// Solve the elastic QP, warm started from the last solve.
  /// @param penalty penalty_k of each group, shape (groups,), in the scaling of the QP
  /// @param curvature curvature of the slacks' cost, larger than 0
  QpResult solve(const QpProblem& problem, const Eigen::VectorXd& penalty,
                 double curvature) noexcept;

  /// Solve the elastic QP from a cold start. For each of the two QPs, ProxQP gets only one attempt
  /// after the active-set method.
  QpResult solve_cold(const QpProblem& problem, const Eigen::VectorXd& penalty,
                      double curvature) noexcept;

  void reset() noexcept;
  /// Solution of the last solve, without the slacks.
  const Eigen::VectorXd& x() const noexcept { return x_; }
  const Eigen::VectorXd& slack() const noexcept { return slack_; }  ///< shape (groups,)
  /// Return whether the next solve starts with the elastic QP. True after a solve of the elastic
  /// QP, until ten consecutive solves had no slack; a failed solve counts as a solve with slack.
  bool elastic_mode() const noexcept { return elastic_mode_; }
  /// Return the QP that was solved last: `problem`, or the elastic QP with its slacks.
  const QpProblem& solved_problem(const QpProblem& problem) const noexcept {
    return used_elastic_ ? elastic_ : problem;
  }

 private:
  struct Budget {
    int hard, elastic;  // inner iterations of ProxQP for the hard and for the elastic QP
  };
  static const Budget kDefaultBudget, kColdBudget;
  QpResult solve(const QpProblem& problem, const Eigen::VectorXd& penalty, double curvature,
                 const Budget& budget) noexcept;
  void warm_start_elastic() noexcept;
  bool within_penalty(const Eigen::VectorXd& penalty) noexcept;
  void write_elastic(const QpProblem& problem, const Eigen::VectorXd& penalty,
                     double curvature) noexcept;
  QpResult solve_elastic(int budget) noexcept;

  int n_, n_in_;
  ElasticRows rows_;
  std::vector<int> lower_row_;  // per row of C: row of elastic_ with its lower bound; -1: hard row
  QpProblem elastic_;
  QpSolver hard_solver_, elastic_solver_;
  Eigen::VectorXd x_, slack_, group_multipliers_, start_multipliers_;
  bool elastic_mode_ = false;
  bool used_elastic_ = false;
  int ticks_without_slack_ = 0;
};

}  // namespace surefoot
