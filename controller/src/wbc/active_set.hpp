// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wbc/active_constraints.hpp"

namespace surefoot {

/// Active-set solver for strictly convex QPs, warm started with the active set of the last QP.
///
/// Method: the dual method of Goldfarb and Idnani (1983). It starts at the optimum for the initial
/// active set. In each step it adds the most violated constraint to the active set and removes the
/// constraints whose multipliers would change sign. It ends when no constraint is violated, or when
/// constraints contradict each other. From one tick to the next the active set hardly changes, so
/// most solves need one small factorisation. Rounding errors are not corrected: the caller must
/// check the solution. Real-time: yes, with at most max_changes changes of the active set.
class ActiveSet {
 public:
  /// Largest number of changes of the active set in one solve; ProxQP solves the QP if more are
  /// needed. Chosen larger than the number that an elastic QP needed: 86 changes from a cold start,
  /// and 24 from the active set of the hard QP (docs/explanation/condensed-qp.md).
  static constexpr int kMaxChanges = 100;

  /// @param max_changes largest number of changes (constraints added plus constraints removed) in
  ///   one solve
  ActiveSet(int n, int n_eq, int n_in, int max_changes = kMaxChanges);

  enum class Outcome { kSolved, kInfeasible, kGaveUp };

  /// Solve a QP. x, y and z change only if the outcome is kSolved.
  /// @param x out: the solution
  /// @param y out: multipliers of A x = b
  /// @param z in: rows with nonzero entries are the initial active set; out: multipliers of
  ///   l <= C x <= u
  /// @return kInfeasible if constraints contradict each other; kGaveUp after max_changes changes,
  /// if a number is not finite, or if rounding errors leave the result undecided
  Outcome solve(const QpProblem& problem, double tolerance, Eigen::VectorXd& x, Eigen::VectorXd& y,
                Eigen::VectorXd& z) noexcept;

  /// Return one plus the number of constraints that the last solve added or removed.
  int iterations() const noexcept { return changes_ + 1; }

 private:
  static constexpr int kNone = -1, kNotFinite = -2;  // special values of Violation::row
  struct Violation {
    int row = kNone;
    double side = 0.0;    // 1: above u, -1: below l
    double amount = 0.0;  // size of the violation, positive
  };
  bool begin(const QpProblem& problem, const Eigen::VectorXd& z) noexcept;
  bool drop_negative_multipliers() noexcept;
  Violation most_violated(const QpProblem& problem, double tolerance) noexcept;
  Outcome add_violated(const QpProblem& problem, const Violation& violation) noexcept;
  Outcome judge_infeasibility(double remaining) noexcept;

  Eigen::Index n_eq_;
  int max_changes_;
  ActiveConstraints active_;  // the active set; equalities come first and are never removed
  Eigen::VectorXd x_, Cx_;
  int changes_ = 0;
};

}  // namespace surefoot
