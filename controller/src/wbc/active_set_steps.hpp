// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// An active set method (Nocedal and Wright 2006, ch. 16): guess which rows lie on a bound, solve
/// the linear system that follows, exchange rows by what its answer violates, and solve again. From
/// one tick to the next these rows seldom change, and then the first step is the answer, to
/// rounding. Exchanges may cycle, and programs without an answer are not told apart from hard ones:
/// a robust solver must stand behind it. Real-time: all but the constructor, allocates nothing.
class ActiveSetSteps {
 public:
  ActiveSetSteps(int n, int n_eq, int n_in);

  /// Take a program, and as first guess the rows with multipliers.
  /// @return false if H is not positive definite, or rows of A depend on each other
  bool start(const QpProblem& problem, const Eigen::VectorXd& multipliers) noexcept;

  /// Solve with the rows guessed on their bounds and the others ignored.
  void step(const QpProblem& problem) noexcept;

  /// Guess anew: rows that would pull go; when none does, the row most beyond its bound comes.
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
  template <typename Row>
  bool add(const Row& normal, int rows) noexcept;

  int n_, n_eq_;
  std::vector<Active> active_;
  Eigen::MatrixXd L_;  // H = L L'
  Eigen::MatrixXd W_;  // L^-1 (A', active rows of C')
  Eigen::MatrixXd S_;  // the Cholesky factor of W'W, in its lower triangle
  Eigen::VectorXd r_;  // L^-1 g
  Eigen::VectorXd m_;  // multipliers of A, then of the active rows
  Eigen::VectorXd factor_row_;
  Eigen::VectorXd x_, y_, z_;
};

}  // namespace surefoot
