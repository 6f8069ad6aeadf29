// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// The primal-dual active set method (Hintermueller, Ito and Kunisch 2003): guess which rows lie on
/// a bound, solve the linear system that follows, and guess again from its answer. From one tick to
/// the next these rows seldom change, and then the first step is the answer, to rounding. It may
/// cycle and knows nothing of programs that have no answer: a robust solver must stand behind it.
/// Real-time: all but the constructor, allocates nothing.
class ActiveSetSteps {
 public:
  ActiveSetSteps(int n, int n_eq, int n_in);

  /// Take a program, and as first guess the rows with multipliers.
  /// @return false if H is not positive definite
  bool start(const QpProblem& problem, const Eigen::VectorXd& multipliers) noexcept;

  /// Solve with the rows guessed on their bounds and the others ignored.
  /// @return false if these rows depend on each other, or are more than fit
  bool step(const QpProblem& problem) noexcept;

  /// Guess anew: rows that would pull go, rows beyond a bound come.
  /// @param Cx at the last step's answer
  /// @return false if nothing changed
  bool guess(const QpProblem& problem, const Eigen::VectorXd& Cx, double tolerance) noexcept;

  const Eigen::VectorXd& x() const noexcept { return x_; }
  const Eigen::VectorXd& y() const noexcept { return y_; }
  const Eigen::VectorXd& z() const noexcept { return z_; }

 private:
  /// A row of C on a bound.
  struct Active {
    int row;
    bool upper;
  };
  bool solve_multipliers(int rows) noexcept;

  int n_, n_eq_;
  std::vector<Active> active_;
  Eigen::MatrixXd L_;             // H = L L'
  Eigen::MatrixXd W_;             // L^-1 (A', active rows of C')
  Eigen::MatrixXd S_;             // W'W, then its Cholesky factor
  Eigen::VectorXd r_;             // L^-1 g
  Eigen::VectorXd m_, diagonal_;  // of the system for the multipliers
  Eigen::VectorXd x_, y_, z_;
};

}  // namespace surefoot
