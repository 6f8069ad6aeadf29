// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/elastic_solver.hpp"

#include <cmath>

namespace surefoot {

namespace {

// Number of solves without slack after which the hard QP is tried again. Chosen. If smaller: more
// ticks solve both QPs. If larger: more ticks solve the larger QP without need. Test:
// elastic_mode_lasts_equally_long_each_time.
constexpr int kTicksWithoutSlack = 10;
// Slack above which a constraint counts as violated. Numerical: ten times the default tolerance,
// 1e-6.
constexpr double kMinSlack = 1e-5;

int elastic_count(const ElasticRows& rows) {
  int count = 0;
  for (const int group : rows.group) count += group >= 0 ? 1 : 0;
  return count;
}

}  // namespace

// Budgets {hard QP, elastic QP}: numbers of inner iterations of ProxQP after which no further
// attempt begins. Chosen. The elastic QP has about twice the variables of the hard QP, so its
// budget is larger. If the budgets were still larger: a tick could exceed its period.
const ElasticSolver::Budget ElasticSolver::kDefaultBudget{40, 160};
const ElasticSolver::Budget ElasticSolver::kColdBudget{1, 1};  // one attempt for each QP

// Rows of the elastic QP, in this order: the rows of the hard QP, where elastic rows keep only
// their upper bound; the lower bounds of the elastic rows; s >= 0.
ElasticSolver::ElasticSolver(int n, int n_eq, const ElasticRows& rows, double tolerance)
    : n_(n),
      n_in_(static_cast<int>(rows.group.size())),
      rows_(rows),
      elastic_(n + rows.groups, n_eq, n_in_ + elastic_count(rows) + rows.groups),
      hard_solver_(n, n_eq, n_in_, tolerance),
      elastic_solver_(n + rows.groups, n_eq, n_in_ + elastic_count(rows) + rows.groups, tolerance),
      x_(Eigen::VectorXd::Zero(n)),
      slack_(Eigen::VectorXd::Zero(rows.groups)),
      group_multipliers_(Eigen::VectorXd::Zero(rows.groups)),
      start_multipliers_(Eigen::VectorXd::Zero(elastic_.l.size())) {
  int next = n_in_;
  for (int row = 0; row < n_in_; ++row) {
    lower_row_.push_back(rows.group[row] >= 0 ? next++ : -1);
    if (rows.group[row] < 0) continue;
    elastic_.C(row, n_ + rows.group[row]) = -1.0;
    elastic_.C(lower_row_[row], n_ + rows.group[row]) = 1.0;
  }
  for (int k = 0; k < rows.groups; ++k) elastic_.C(next + k, n_ + k) = 1.0;
  elastic_.l.setConstant(-kNoBound);
  elastic_.u.setConstant(kNoBound);
  elastic_.l.tail(rows.groups).setZero();
}

void ElasticSolver::reset() noexcept {
  hard_solver_.reset();
  elastic_solver_.reset();
  elastic_mode_ = false;
  ticks_without_slack_ = 0;
}

QpResult ElasticSolver::solve(const QpProblem& problem, const Eigen::VectorXd& penalty,
                              double curvature) noexcept {
  return solve(problem, penalty, curvature, kDefaultBudget);
}

QpResult ElasticSolver::solve_cold(const QpProblem& problem, const Eigen::VectorXd& penalty,
                                   double curvature) noexcept {
  reset();
  return solve(problem, penalty, curvature, kColdBudget);
}

QpResult ElasticSolver::solve(const QpProblem& problem, const Eigen::VectorXd& penalty,
                              double curvature, const Budget& budget) noexcept {
  int spent = 0;
  used_elastic_ = false;
  if (!elastic_mode_) {
    QpResult result = hard_solver_.solve(problem, budget.hard, Feasibility::kDoubtful);
    if (result.status == Status::kNonFinite) return result;
    if (result.status == Status::kOk && within_penalty(penalty)) {
      x_ = hard_solver_.x();
      slack_.setZero();
      return result;
    }
    spent = result.iterations;
    warm_start_elastic();
  }
  write_elastic(problem, penalty, curvature);
  used_elastic_ = true;
  QpResult result = solve_elastic(budget.elastic);
  result.iterations += spent;
  return result;
}

// Start the elastic solver from the active set of the hard QP, with all slacks zero.
void ElasticSolver::warm_start_elastic() noexcept {
  ticks_without_slack_ = 0;
  start_multipliers_.setZero();
  for (int row = 0; row < n_in_; ++row) {
    const double z = hard_solver_.z()[row];
    start_multipliers_[z < 0.0 && lower_row_[row] >= 0 ? lower_row_[row] : row] = z;
  }
  start_multipliers_.tail(rows_.groups).setConstant(-1.0);
  elastic_solver_.warm_start_from(start_multipliers_);
}

// Return whether, in each group, the sum of the |multipliers| of the hard QP is at most the
// penalty.
bool ElasticSolver::within_penalty(const Eigen::VectorXd& penalty) noexcept {
  group_multipliers_.setZero();
  for (int row = 0; row < n_in_; ++row) {
    if (rows_.group[row] >= 0)
      group_multipliers_[rows_.group[row]] += std::abs(hard_solver_.z()[row]);
  }
  return (group_multipliers_.array() <= penalty.array()).all();
}

void ElasticSolver::write_elastic(const QpProblem& problem, const Eigen::VectorXd& penalty,
                                  double curvature) noexcept {
  elastic_.H.topLeftCorner(n_, n_) = problem.H;
  elastic_.H.bottomRightCorner(rows_.groups, rows_.groups).diagonal().setConstant(curvature);
  elastic_.g.head(n_) = problem.g;
  elastic_.g.tail(rows_.groups) = penalty;
  elastic_.A.leftCols(n_) = problem.A;
  elastic_.b = problem.b;
  elastic_.C.topLeftCorner(n_in_, n_) = problem.C;
  elastic_.u.head(n_in_) = problem.u;
  for (int row = 0; row < n_in_; ++row) {
    const int lower = lower_row_[row];
    if (lower < 0) {
      elastic_.l[row] = problem.l[row];
    } else {
      elastic_.C.row(lower).head(n_) = problem.C.row(row);
      elastic_.l[lower] = problem.l[row];
    }
  }
}

QpResult ElasticSolver::solve_elastic(int budget) noexcept {
  QpResult result = elastic_solver_.solve(elastic_, budget);
  if (result.status == Status::kNonFinite) return result;
  x_ = elastic_solver_.x().head(n_);
  slack_ = elastic_solver_.x().tail(rows_.groups);
  // A failed solve counts as a solve with slack, so the elastic mode continues.
  const bool slack_or_failed = slack_.maxCoeff() > kMinSlack || result.status != Status::kOk;
  ticks_without_slack_ = slack_or_failed ? 0 : ticks_without_slack_ + 1;
  elastic_mode_ = ticks_without_slack_ < kTicksWithoutSlack;
  return result;
}

}  // namespace surefoot
