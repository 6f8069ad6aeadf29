// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wbc/active_constraints.hpp"

namespace surefoot {

/// Solves a strictly convex program from the rows that were active in the last one.
///
/// The dual method of Goldfarb and Idnani (1983): rows join one by one, the most violated first,
/// and leave when their multiplier would change its sign. From one tick to the next hardly any row
/// changes, so that most solves are one small factorisation. It ends, or finds the rows to
/// contradict each other; rounding is the caller's to check. Real-time: yes, at most max_changes.
class ActiveSet {
 public:
  static constexpr int kMaxChanges = 100;

  /// @param max_changes rows that may join or leave in a solve
  ActiveSet(int n, int n_eq, int n_in, int max_changes = kMaxChanges);

  enum class Outcome { kSolved, kInfeasible, kGaveUp };

  /// @param x out: the answer, if solved
  /// @param y out: multipliers of A x = b, if solved
  /// @param z in: the rows to begin with are those where it is not zero; out: multipliers of
  ///   l <= C x <= u, if solved
  Outcome solve(const QpProblem& problem, double tolerance, Eigen::VectorXd& x, Eigen::VectorXd& y,
                Eigen::VectorXd& z) noexcept;

  /// Of the last solve: rows that joined or left, plus one.
  int iterations() const noexcept { return changes_ + 1; }

 private:
  static constexpr int kNone = -1, kNotFinite = -2;  // in the place of a row
  struct Violation {
    int row = kNone;
    double side = 0.0;    // 1: above u, -1: below l
    double amount = 0.0;  // of the side's inequality
  };
  bool begin(const QpProblem& problem, const Eigen::VectorXd& z) noexcept;
  bool drop_negative_multipliers() noexcept;
  Violation most_violated(const QpProblem& problem, double tolerance) noexcept;
  Outcome add_violated(const QpProblem& problem, const Violation& violation) noexcept;
  Outcome judge_infeasibility(double missing) noexcept;

  Eigen::Index n_eq_;
  int max_changes_;
  ActiveConstraints rows_;  // equalities first: they never leave
  Eigen::VectorXd x_, Cx_;
  int changes_ = 0;
};

}  // namespace surefoot
