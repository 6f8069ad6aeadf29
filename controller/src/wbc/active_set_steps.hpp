// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// A dual active set method (Goldfarb and Idnani 1983) that starts from guessed rows: among the
/// multipliers of the rows on a bound, those that minimise with no row pulling; then the row most
/// beyond its bound enters, and so on. From one tick to the next these rows seldom change, and then
/// the first step is the answer, to rounding. Rows behind one that was dropped are factored anew:
/// the systems are small, and nothing drifts. Exchanges are bounded, so a robust solver must stand
/// behind it. Real-time: all but the constructor, allocates nothing.
class ActiveSetSteps {
 public:
  ActiveSetSteps(int n, int n_eq, int n_in);

  /// Take a program, and as first guess the rows with multipliers.
  /// @return false if H is not positive definite, or rows of A depend on each other
  bool start(const QpProblem& problem, const Eigen::VectorXd& multipliers) noexcept;

  /// Solve with the active rows, dropping those that would pull, and ignoring all others.
  /// @return false if there is no such answer, or too many exchanges were made
  bool step(const QpProblem& problem) noexcept;

  /// Let the row that is most beyond its bound become active.
  /// @param Cx at the last step's answer
  /// @return false if none is
  bool enter(const QpProblem& problem, const Eigen::VectorXd& Cx, double tolerance) noexcept;

  const Eigen::VectorXd& x() const noexcept { return x_; }
  const Eigen::VectorXd& y() const noexcept { return y_; }
  const Eigen::VectorXd& z() const noexcept { return z_; }

 private:
  /// A row of C on a bound; its multiplier's sign is `side`.
  struct Active {
    int row;
    double side;  // 1: u, -1: l
  };
  enum class Factored { kAll, kTraded, kInfeasible };

  bool settle(const QpProblem& problem) noexcept;
  Factored factor(const QpProblem& problem) noexcept;
  bool add(const QpProblem& problem, int row, int count) noexcept;
  bool trade(Active entering, int count) noexcept;
  void solve_multipliers(const QpProblem& problem) noexcept;
  int move_multipliers(const QpProblem& problem) noexcept;
  int count() const noexcept { return n_eq_ + static_cast<int>(active_.size()); }

  int n_, n_eq_;
  std::vector<Active> active_;
  bool entering_ = false;  // is the last one new?
  int exchanges_ = 0;
  int factored_ = 0;            // so many of A's and the active rows have their place in W and S
  Eigen::MatrixXd L_;           // H = L L'
  Eigen::MatrixXd W_;           // L^-1 (A', active rows of C'), and room for one more
  Eigen::MatrixXd S_;           // the Cholesky factor of W'W, in its lower triangle
  Eigen::VectorXd r_;           // L^-1 g
  Eigen::VectorXd m_, target_;  // multipliers of A, then of the active rows: now, and without signs
  Eigen::VectorXd factor_row_;
  Eigen::VectorXd x_, y_, z_;
};

}  // namespace surefoot
