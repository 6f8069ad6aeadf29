// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "surefoot/qp_problem.hpp"

namespace surefoot {

/// The active constraints of a QP, and the optimum with all of them as equalities.
///
/// Constraint k is  side_k c_k'x = bound_k  with multiplier m_k. The optimum satisfies
///   H x + g + sum_k m_k side_k c_k = 0.
/// With H = L L', w = -L^-1 g and one column L^-1 side_k c_k of V per constraint:
///   V'V m = V'w - bounds,   x = L'^-1 (w - V m)
/// The class keeps R, the lower triangular Cholesky factor of V'V, and updates it whenever a
/// constraint is added or removed. Real-time: all functions except the constructor.
class ActiveConstraints {
 public:
  /// @param n number of variables
  /// @param n_eq number of rows of A, including rows that are all zeros (GeneralQp writes zero rows
  ///   for soft feet). There is room for n_eq + n constraints
  ActiveConstraints(int n, int n_eq);

  /// Set the QP and remove all constraints. @return false if H is not finite or not positive
  /// definite
  bool start(const QpProblem& problem) noexcept;

  /// Add all equalities A x = b, before any other row. @return false if the rows of A depend on
  /// each other
  bool start_equalities(const RowMatrix& A, const Eigen::VectorXd& b) noexcept;

  /// Project a candidate row side c on the active rows. The residual is the part of the candidate
  /// row that the active rows do not span. is_dependent(), squared_residual(), residual_norm(),
  /// dual_direction() and append() use the row that was projected last.
  template <typename Row>
  void project(const Row& c, double side) noexcept {
    v_ = side * c.transpose();
    project_column();
  }
  bool is_dependent() const noexcept;  ///< true if the residual is zero within rounding
  double squared_residual() const noexcept {
    return squared_residual_;
  }  ///< squared norm r'H^-1 r of the residual r
  /// Compute the norm of the residual of a nearly dependent row. For such a row squared_residual()
  /// loses all digits by cancellation. The call overwrites the candidate row: call it once, and do
  /// not append the row afterwards.
  double residual_norm() noexcept;
  double dual_direction(Eigen::Index k) const {
    return dual_direction_[k];
  }  ///< decrease of the multiplier of constraint k for a unit step towards the candidate row

  /// Add the candidate row. @return false, without a change, if it depends on the active rows
  bool append(int row, double side, double bound, double multiplier) noexcept;
  /// Remove the constraint at position k of the active set, which is the k of row(k).
  void remove(Eigen::Index k) noexcept;

  /// Compute the multipliers with all active rows on their bounds.
  void solve_multipliers() noexcept;
  /// Change the multipliers by a step towards the candidate row: m -= length * dual_direction.
  void step(double length) noexcept {
    multipliers_.head(count_) -= length * dual_direction_.head(count_);
  }
  /// Compute x for the present multipliers.
  const Eigen::VectorXd& solve_x() noexcept;

  Eigen::Index count() const noexcept { return count_; }
  /// Index, in A (equalities) or in C, of the constraint at position k of the active set.
  int row(Eigen::Index k) const noexcept { return rows_[static_cast<std::size_t>(k)]; }
  /// 1: upper bound, -1: lower bound
  double side(Eigen::Index k) const noexcept { return sides_[k]; }
  double value(Eigen::Index k) const noexcept {
    return sides_[k] * bounds_[k];
  }  ///< value of c_k'x when constraint k is on its bound
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
      dual_direction_;  // candidate row: v = L^-1 side c, l = R^-1 V'v, dual_direction = R'^-1 l
  double squared_residual_ = 0.0;
};

}  // namespace surefoot
