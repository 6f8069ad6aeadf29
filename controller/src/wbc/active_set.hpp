// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// Solves a strictly convex program without equalities, from the rows that were active in the last.
///
/// The dual method of Goldfarb and Idnani (1983): rows join one by one, the most violated first,
/// and leave when their multiplier would change its sign. From one tick to the next hardly any row
/// changes, so that most solves are one small factorisation. It ends, or finds the rows to
/// contradict each other; rounding is the caller's to check. Real-time: yes, at most kMostChanges.
class ActiveSet {
 public:
  ActiveSet(int n, int n_in);

  static constexpr int kMostChanges = 60;  ///< of the active rows

  enum class Outcome { kSolved, kInfeasible, kGaveUp };

  /// @param x in: not read; out: the answer, if solved
  /// @param z in: the rows to begin with are those where it is not zero; out: multipliers, if
  /// solved
  Outcome solve(const QpProblem& problem, double tolerance, Eigen::VectorXd& x,
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
  void drop_pulling_rows() noexcept;
  Violation worst(const QpProblem& problem, double tolerance) noexcept;
  Outcome add(const QpProblem& problem, Violation violation) noexcept;
  void direct(const QpProblem& problem, int row, double side) noexcept;
  bool append(int row, double side, double bound, double multiplier) noexcept;
  void remove(Eigen::Index k) noexcept;
  void factorise() noexcept;
  void solve_multipliers() noexcept;

  int n_, n_in_;
  Eigen::LLT<Eigen::MatrixXd> H_;  // L L' = H
  Eigen::VectorXd free_;           // -L^-1 g
  Eigen::Index count_ = 0;         // active rows, each as  side c'x <= bound
  std::vector<int> rows_;
  Eigen::VectorXd sides_, bounds_, multipliers_;
  Eigen::MatrixXd V_, R_;  // V: L^-1 side c, a column each; R R' = V'V
  Eigen::VectorXd x_, Cx_;
  Eigen::VectorXd v_, l_, step_;  // of the row that joins: its V, R^-1 V'v, and R'^-1 of that
  double length_ = 0.0;           // squared, of what V does not span of v
  int changes_ = 0;
};

}  // namespace surefoot
