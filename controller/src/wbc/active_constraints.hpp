// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// The rows of a program that are taken as equalities, each as  side c'x = bound, and what solves
/// with them:  H x + g + sum_k m_k side_k c_k = 0.
///
/// With H = L L', w = -L^-1 g and a column L^-1 side c of V per row it is  V'V m = V'w - bounds,
/// x = L'^-1 (w - V m); of V'V there is the Cholesky factor R. Real-time: yes.
class ActiveConstraints {
 public:
  /// @param n unknowns @param n_eq equalities, of which some may be rows of nothing: there are no
  /// more than n others that do not depend on each other
  ActiveConstraints(int n, int n_eq);

  /// Take a program, without rows. @return is H positive definite?
  bool start(const QpProblem& problem) noexcept;

  /// Take in A x = b, all rows at once, before any other. @return do they not depend on each other?
  bool start_equalities(const RowMatrix& A, const Eigen::VectorXd& b) noexcept;

  /// Look at a row: what of it do the rows that are there not span?
  template <typename Row>
  void project(const Row& c, double side) noexcept {
    v_ = side * c.transpose();
    project_column();
  }
  bool is_dependent() const noexcept;  ///< nothing: it follows from them
  double squared_residual() const noexcept {
    return squared_residual_;
  }  ///< its squared length, in H's metric
  /// How long the part is that they do not span, where squared_residual() would be a difference of
  /// equals.
  double residual_norm() noexcept;
  double dual_direction(Eigen::Index k) const {
    return dual_direction_[k];
  }  ///< what it takes from multiplier k

  /// Take in the row that was looked at last, unless it depends on the others.
  bool append(int row, double side, double bound, double multiplier) noexcept;
  void remove(Eigen::Index k) noexcept;

  /// Multipliers of the answer that has all rows on their bounds.
  void solve_multipliers() noexcept;
  /// Take a step towards the row looked at: each multiplier loses its share of the length.
  void step(double length) noexcept {
    multipliers_.head(count_) -= length * dual_direction_.head(count_);
  }
  /// The x that belongs to the multipliers.
  const Eigen::VectorXd& solve_x() noexcept;

  Eigen::Index count() const noexcept { return count_; }
  int row(Eigen::Index k) const noexcept { return rows_[static_cast<std::size_t>(k)]; }
  double side(Eigen::Index k) const noexcept { return sides_[k]; }
  double value(Eigen::Index k) const noexcept { return sides_[k] * bounds_[k]; }  ///< of c'x
  double multiplier(Eigen::Index k) const noexcept { return multipliers_[k]; }
  const Eigen::VectorXd& multipliers() const noexcept { return multipliers_; }

 private:
  void project_column() noexcept;
  void factorise(Eigen::Index from) noexcept;

  Eigen::LLT<Eigen::MatrixXd> H_;
  Eigen::VectorXd w_, x_;
  Eigen::Index count_ = 0;
  std::vector<int> rows_;
  Eigen::VectorXd sides_, bounds_, multipliers_;
  Eigen::MatrixXd V_, R_;
  Eigen::VectorXd v_, l_,
      dual_direction_;  // of the row looked at: its column, R^-1 V'v, R'^-1 of that
  double squared_residual_ = 0.0;
};

}  // namespace surefoot
