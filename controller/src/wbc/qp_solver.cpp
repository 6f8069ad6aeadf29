// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_solver.hpp"

#include "surefoot/stage_clock.hpp"
#include "wbc/active_set.hpp"
#include "wbc/proxqp_runner.hpp"
#include "wbc/qp_check.hpp"

namespace surefoot {

namespace {

// Chosen by hand. Tests: proxqp_alone_solves_97_percent_of_degenerate_qps,
// both_methods_meet_a_tolerance_of_1e_minus_12.
constexpr int kWarmAttempts = 3;  // a warm start, then two attempts from the corrected last result
constexpr int kAttempts = 6;      // the warm attempts, then a cold start and two more attempts
constexpr double kTightTolerance =
    1e-8;  // smaller tolerances are for offline checks without a deadline
// Factor on the number of attempts and on the budget for tolerances below kTightTolerance.
constexpr int kTightFactor = 10;

}  // namespace

struct QpSolver::Workspace {
  Workspace(int n, int n_eq, int n_in, int max_changes)
      : active_set(n, n_eq, n_in, max_changes), proxqp(n, n_eq, n_in), check(n, n_eq, n_in) {}
  ActiveSet active_set;
  ProxqpRunner proxqp;  // its x, y and z hold the solution of either solver
  QpCheck check;
};

QpSolver::QpSolver(int n, int n_eq, int n_in, double tolerance)
    : QpSolver(n, n_eq, n_in, tolerance, ActiveSet::kMaxChanges) {}

QpSolver::QpSolver(int n, int n_eq, int n_in, double tolerance, int max_changes)
    : workspace_(std::make_unique<Workspace>(n, n_eq, n_in, max_changes)),
      attempt_factor_(tolerance < kTightTolerance ? kTightFactor : 1) {
  set_tolerance(tolerance);
}

QpSolver::~QpSolver() = default;

void QpSolver::reset() noexcept { has_solution_ = false; }

void QpSolver::warm_start_from(const Eigen::VectorXd& z) noexcept {
  clear_solution();
  workspace_->proxqp.z() = z;
  has_solution_ = true;
}

const Eigen::VectorXd& QpSolver::x() const noexcept { return workspace_->proxqp.x(); }
const Eigen::VectorXd& QpSolver::y() const noexcept { return workspace_->proxqp.y(); }
const Eigen::VectorXd& QpSolver::z() const noexcept { return workspace_->proxqp.z(); }

void QpSolver::set_tolerance(double tolerance) noexcept {
  tolerance_ = tolerance;
  workspace_->proxqp.set_tolerance(tolerance);
}

QpResult QpSolver::solve(const QpProblem& problem, int budget, Feasibility feasibility) noexcept {
  const StageScope stage(Stage::kSolve);
  if (!has_solution_) clear_solution();
  QpResult result = try_active_set(problem);
  if (result.status == Status::kOk) return result;
  if (!QpCheck::finite(problem)) {
    result.status = Status::kNonFinite;
    return result;
  }
  if (result.status == Status::kInfeasible && feasibility == Feasibility::kDoubtful) return result;
  const int changes = result.iterations;  // added to the result, but not counted against the budget
  result = run_proxqp(problem, budget);
  result.iterations += changes;
  return result;
}

// From tick to tick the active set hardly changes, so ActiveSet usually finds the solution.
QpResult QpSolver::try_active_set(const QpProblem& problem) noexcept {
  ActiveSet& active_set = workspace_->active_set;
  ProxqpRunner& proxqp = workspace_->proxqp;
  const auto outcome = active_set.solve(problem, tolerance_, proxqp.x(), proxqp.y(), proxqp.z());
  QpResult result;
  if (outcome == ActiveSet::Outcome::kSolved) result = check(problem);
  if (outcome == ActiveSet::Outcome::kInfeasible) result.status = Status::kInfeasible;
  result.iterations = active_set.iterations();
  has_solution_ = result.status == Status::kOk;
  return result;
}

QpResult QpSolver::run_proxqp(const QpProblem& problem, int budget) noexcept {
  ProxqpRunner& proxqp = workspace_->proxqp;
  QpResult result;
  int spent = 0;
  proxqp.set_problem(problem);
  for (int attempt = 0; attempt < attempt_factor_ * kAttempts; ++attempt) {
    if (attempt % kAttempts == kWarmAttempts || !x().allFinite()) clear_solution();
    const ProxqpRunner::Outcome outcome = proxqp.run();
    spent += outcome.iterations;
    result = check(problem);
    if (result.status == Status::kOk) break;
    if (outcome.infeasible) result.status = Status::kInfeasible;
    if (spent >= attempt_factor_ * budget) break;
    drop_inactive_multipliers(problem);
  }
  result.iterations = spent;
  has_solution_ = result.status == Status::kOk;
  return result;
}

void QpSolver::clear_solution() noexcept {
  ProxqpRunner& proxqp = workspace_->proxqp;
  proxqp.x().setZero();
  proxqp.y().setZero();
  proxqp.z().setZero();
}

// A nonzero multiplier on a row away from its bound shows that the solution is not optimal yet. Set
// such multipliers to zero before the next attempt.
void QpSolver::drop_inactive_multipliers(const QpProblem& problem) noexcept {
  Eigen::VectorXd& z = workspace_->proxqp.z();
  const Eigen::VectorXd& Cx = workspace_->check.Cx();
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    if (!(QpCheck::row_gap(z[i], Cx[i], problem.l[i], problem.u[i]) <= tolerance_)) z[i] = 0.0;
  }
}

// The status depends on residuals of the original QP, not on what the solver reports.
QpResult QpSolver::check(const QpProblem& problem) noexcept {
  const StageScope stage(Stage::kCheck);
  return workspace_->check(problem, x(), y(), z(), tolerance_);
}

}  // namespace surefoot
