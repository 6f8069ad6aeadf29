// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "wbc/qp_solver.hpp"

namespace surefoot {

/// Which rows of C may give way, and in which groups.
struct ElasticRows {
  int groups = 0;
  std::vector<int> group;  ///< per row of C: its group, or -1 for a row that never gives way
};

/// Solves   minimise  1/2 x'H x + g'x + sum_k (price_k s_k + 1/2 curvature s_k^2)
///          subject to  A x = b,  l - s <= C x <= u + s,  s >= 0   (s: one slack a group)
/// The penalty is exact (Nocedal and Wright 2006, thm. 17.3): while the program with hard rows has
/// multipliers that sum to less than the price in every group, its answer is the elastic one's
/// too. So the small hard program is solved first, and the large one only while something gives.
/// Real-time: solve() yes.
class ElasticSolver {
 public:
  ElasticSolver(int n, int n_eq, const ElasticRows& rows, double tolerance);

  /// Ask for this from the next solve on.
  void set_tolerance(double tolerance) noexcept {
    hard_solver_.set_tolerance(tolerance);
    elastic_solver_.set_tolerance(tolerance);
  }

  /// @param penalty shape (groups,) @param curvature more than 0
  QpResult solve(const QpProblem& problem, const Eigen::VectorXd& penalty,
                 double curvature) noexcept;

  /// From nothing, and with one attempt of ProxQP's behind the active set instead of several.
  QpResult solve_cold(const QpProblem& problem, const Eigen::VectorXd& penalty,
                      double curvature) noexcept;

  void reset() noexcept;
  const Eigen::VectorXd& x() const noexcept { return x_; }
  const Eigen::VectorXd& slack() const noexcept { return slack_; }  ///< shape (groups,)
  bool slack_active() const noexcept { return slack_active_; }
  /// The program that the last answer is of: the caller's, or the large one with slacks.
  const QpProblem& solved_problem(const QpProblem& problem) const noexcept {
    return used_elastic_ ? elastic_ : problem;
  }

 private:
  struct Budget {
    int hard, elastic;  // inner iterations of ProxQP
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
  std::vector<int> lower_row_;  // where an elastic row's lower side stands in elastic_
  QpProblem elastic_;
  QpSolver hard_solver_, elastic_solver_;
  Eigen::VectorXd x_, slack_, group_multipliers_, start_multipliers_;
  bool slack_active_ = false;
  bool used_elastic_ = false;
  int ticks_without_slack_ = 0;
};

}  // namespace surefoot
