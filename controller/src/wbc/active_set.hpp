// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// Solves a strictly convex program from the rows that were active in the last one.
///
/// The primal-dual active set method (Hintermueller, Ito, Kunisch 2003): take rows as equalities,
/// drop those whose multiplier has the wrong sign, take in those that are violated, and again. From
/// one tick to the next the active rows hardly change, so that it mostly ends in its first or
/// second round; where it does not end, a solver that always does has to take over. Real-time: yes,
/// at most kRounds small factorisations.
class ActiveSet {
 public:
  ActiveSet(int n, int n_in);

  static constexpr int kRounds = 8;

  /// @param x in: not read; out: the answer, unchanged without one
  /// @param z in: the rows to begin with are those where it is not zero; out: multipliers
  /// @return found: every row within the tolerance, every multiplier of the right sign; not checked
  ///   against rounding
  bool solve(const QpProblem& problem, double tolerance, Eigen::VectorXd& x,
             Eigen::VectorXd& z) noexcept;

  /// Of the last solve.
  int rounds() const noexcept { return rounds_; }

 private:
  bool begin(const QpProblem& problem, const Eigen::VectorXd& z) noexcept;
  bool solve_active(const QpProblem& problem) noexcept;
  bool settle(const QpProblem& problem, double tolerance) noexcept;

  int n_, n_in_, most_;            // most_: rows that can be active at once
  std::vector<signed char> side_;  // per row: -1 at l, 1 at u, 0 inactive
  std::vector<int> active_;        // the rows at a side, in order
  Eigen::LLT<Eigen::MatrixXd> H_;  // L L' = H
  Eigen::MatrixXd V_, S_;          // L^-1 of the active rows, transposed; its Gram matrix
  Eigen::VectorXd free_, x_, rhs_, multipliers_, Cx_;  // free_: L^-1 (-g)
  int rounds_ = 0;
};

}  // namespace surefoot
