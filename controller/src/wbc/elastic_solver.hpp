// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wbc/qp_solver.hpp"

namespace surefoot {

/// The elastic rows of C and their groups.
struct ElasticRows {
  int groups = 0;
  std::vector<int> group;  ///< per row of C: its group, or -1 for a hard row
};

/// Solver for QPs with elastic constraints, which may be violated at a penalty:
///   minimise    1/2 x'H x + g'x + sum_k (penalty_k s_k + 1/2 curvature s_k^2)
///   subject to  A x = b,   l - s <= C x <= u + s,   s >= 0
/// The rows of group k share the slack s_k; hard rows have none. The QP is feasible if its hard
/// constraints are.
///
/// The penalty is linear and therefore exact (Nocedal and Wright 2006, thm. 17.3). Take the QP
/// with all rows hard. If the sum of its multipliers is at most penalty_k in every group, its
/// solution also solves the elastic QP with s = 0. The solver uses this: it solves the small hard
/// QP first, and the larger elastic QP only if the hard one is infeasible or exceeds a penalty.
/// While slacks are nonzero, and for ten ticks after, it goes straight to the elastic QP.
/// Real-time: solve() yes.
class ElasticSolver {
 public:
  ElasticSolver(int n, int n_eq, const ElasticRows& rows, double tolerance);

  /// Set the tolerance, from the next solve on.
  void set_tolerance(double tolerance) noexcept {
    hard_solver_.set_tolerance(tolerance);
    elastic_solver_.set_tolerance(tolerance);
  }

  /// Solve the elastic QP, warm started from the last solve.
  /// @param penalty shape (groups,), in the scaling of the QP
  /// @param curvature of the slacks' cost, larger than 0
  QpResult solve(const QpProblem& problem, const Eigen::VectorXd& penalty,
                 double curvature) noexcept;

  /// Solve from a cold start. After the active-set method ProxQP gets one attempt only.
  QpResult solve_cold(const QpProblem& problem, const Eigen::VectorXd& penalty,
                      double curvature) noexcept;

  void reset() noexcept;
  const Eigen::VectorXd& x() const noexcept { return x_; }
  const Eigen::VectorXd& slack() const noexcept { return slack_; }  ///< shape (groups,)
  bool slack_active() const noexcept { return slack_active_; }
  /// Return the QP that was solved last: `problem`, or the elastic QP with slacks.
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
  std::vector<int> lower_row_;  // row of elastic_ with an elastic row's lower bound, or -1
  QpProblem elastic_;
  QpSolver hard_solver_, elastic_solver_;
  Eigen::VectorXd x_, slack_, group_multipliers_, start_multipliers_;
  bool slack_active_ = false;
  bool used_elastic_ = false;
  int ticks_without_slack_ = 0;
};

}  // namespace surefoot
