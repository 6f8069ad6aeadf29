// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/active_set.hpp"

#include <cmath>
#include <limits>

namespace surefoot {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Violation above which a constraint counts as violated, as a share of the tolerance. Chosen:
// smaller than 1, so that the solution passes QpCheck with a margin, and larger than rounding
// errors. Test: test_active_set.cpp.
constexpr double kViolationShare = 0.1;
// Largest plausible distance from the present x to a point that satisfies the violated row and all
// active rows: the norm sqrt(d'H d) of the difference d, with trace(H) = n. Chosen: far larger than
// solutions in QP units, which are of order 1. Test:
// nearly_parallel_constraints_are_not_reported_as_infeasible.
constexpr double kMaxDistance = 1e4;

double bound_of(const QpProblem& problem, int row, double side) noexcept {
  return side > 0.0 ? problem.u[row] : -problem.l[row];
}

}  // namespace

ActiveSet::ActiveSet(int n, int n_eq, int n_in, int max_changes)
    : n_eq_(n_eq),
      max_changes_(max_changes),
      active_(n, n_eq),
      x_(Eigen::VectorXd::Zero(n)),
      Cx_(Eigen::VectorXd::Zero(n_in)) {}

ActiveSet::Outcome ActiveSet::solve(const QpProblem& problem, double tolerance, Eigen::VectorXd& x,
                                    Eigen::VectorXd& y, Eigen::VectorXd& z) noexcept {
  changes_ = 0;
  if (!begin(problem, z) || !drop_negative_multipliers()) return Outcome::kGaveUp;
  for (;;) {
    const Violation violation = most_violated(problem, kViolationShare * tolerance);
    if (violation.row == kNotFinite) return Outcome::kGaveUp;
    if (violation.row == kNone) break;
    const Outcome added = add_violated(problem, violation);
    if (added != Outcome::kSolved) return added;
  }
  x = x_;
  y = active_.multipliers().head(n_eq_);
  z.setZero();
  for (Eigen::Index k = n_eq_; k < active_.count(); ++k) {
    z[active_.row(k)] = active_.side(k) * active_.multiplier(k);
  }
  return Outcome::kSolved;
}

bool ActiveSet::begin(const QpProblem& problem, const Eigen::VectorXd& z) noexcept {
  if (!active_.start(problem)) return false;
  if (!active_.start_equalities(problem.A, problem.b)) return false;
  for (int row = 0; row < z.size(); ++row) {
    if (z[row] == 0.0) continue;
    const double side = z[row] > 0.0 ? 1.0 : -1.0;
    const double bound = bound_of(problem, row, side);
    if (!(std::abs(bound) < kNoBound)) continue;
    active_.project(problem.C.row(row), side);
    active_.append(row, side, bound, 0.0);  // append() skips rows that depend on earlier ones
  }
  return true;
}

// The dual method must start from an active set without negative multipliers.
bool ActiveSet::drop_negative_multipliers() noexcept {
  for (;;) {
    active_.solve_multipliers();
    Eigen::Index worst = -1;
    double smallest = 0.0;
    for (Eigen::Index k = n_eq_; k < active_.count(); ++k) {
      if (active_.multiplier(k) >= smallest) continue;
      smallest = active_.multiplier(k);
      worst = k;
    }
    if (worst < 0) return true;
    if (changes_ == max_changes_) return false;
    active_.remove(worst);
    ++changes_;
  }
}

// Return the most violated constraint. The entries of Cx for active rows are set to their bounds: a
// rounding error there is no violation, but would make the method exchange rows.
ActiveSet::Violation ActiveSet::most_violated(const QpProblem& problem, double tolerance) noexcept {
  x_ = active_.solve_x();
  Cx_.noalias() = problem.C * x_;
  for (Eigen::Index k = n_eq_; k < active_.count(); ++k) Cx_[active_.row(k)] = active_.value(k);
  Violation found;
  found.amount = tolerance;
  for (int row = 0; row < Cx_.size(); ++row) {
    const double above = Cx_[row] - problem.u[row], below = problem.l[row] - Cx_[row];
    if (std::isnan(above) || std::isnan(below)) return {kNotFinite, 0.0, 0.0};
    if (above > found.amount) found = {row, 1.0, above};
    if (below > found.amount) found = {row, -1.0, below};
  }
  return found;
}

// Step towards the violated constraint until it holds, and add it to the active set. If the
// multiplier of an active constraint reaches zero first, remove that constraint and continue. The
// outcome kSolved means here that the constraint was added; other constraints may be violated.
ActiveSet::Outcome ActiveSet::add_violated(const QpProblem& problem,
                                           const Violation& violation) noexcept {
  const auto& [row, side, amount] = violation;
  double remaining = amount, multiplier = 0.0;
  for (;;) {
    if (changes_ == max_changes_) return Outcome::kGaveUp;
    ++changes_;
    active_.project(problem.C.row(row), side);
    const bool dependent = active_.is_dependent();
    double length = dependent ? kInfinite : remaining / active_.squared_residual();
    Eigen::Index blocking = -1;
    for (Eigen::Index k = n_eq_; k < active_.count(); ++k) {
      if (active_.dual_direction(k) <= 0.0 ||
          active_.dual_direction(k) * length <= active_.multiplier(k))
        continue;
      length = active_.multiplier(k) / active_.dual_direction(k);
      blocking = k;
    }
    if (!(length < kInfinite)) return judge_infeasibility(remaining);
    active_.step(length);
    multiplier += length;
    if (blocking < 0) {
      const bool appended = active_.append(row, side, bound_of(problem, row, side), multiplier);
      return appended ? Outcome::kSolved : Outcome::kGaveUp;
    }
    if (!dependent) remaining -= length * active_.squared_residual();
    active_.remove(blocking);
  }
}

// The violated row depends on the active rows, and no multiplier limits the step. So the violated
// constraint and the active constraints contradict each other. If the row is only nearly dependent,
// a distant point may satisfy all of them. The outcome is then kGaveUp, and ProxQP has to decide.
ActiveSet::Outcome ActiveSet::judge_infeasibility(double remaining) noexcept {
  const bool certain = remaining > kMaxDistance * active_.residual_norm();
  return certain ? Outcome::kInfeasible : Outcome::kGaveUp;
}

}  // namespace surefoot
