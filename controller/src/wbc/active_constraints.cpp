// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/active_constraints.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {
// A row counts as dependent on the active rows if the squared norm of its residual is at most this
// share of the squared norm of the whole row. Both norms are c'H^-1 c. Numerical tolerance; test:
// degenerate_and_near_parallel_constraints_are_solved.
constexpr double kMinIndependent = 1e-9;
}  // namespace

ActiveConstraints::ActiveConstraints(int n, int n_eq)
    : H_(n),
      w_(Eigen::VectorXd::Zero(n)),
      x_(w_),
      rows_(static_cast<std::size_t>(n + n_eq), 0),
      sides_(Eigen::VectorXd::Zero(n + n_eq)),
      bounds_(sides_),
      multipliers_(sides_),
      V_(Eigen::MatrixXd::Zero(n, n + n_eq)),
      R_(Eigen::MatrixXd::Zero(n + n_eq, n + n_eq)),
      v_(w_),
      l_(sides_),
      dual_direction_(sides_) {}

bool ActiveConstraints::start(const QpProblem& problem) noexcept {
  count_ = 0;
  // The factorisation reads only one triangle of H, so it would miss a NaN in the other triangle.
  if (!problem.H.allFinite()) return false;
  H_.compute(problem.H);
  if (H_.info() != Eigen::Success) return false;
  w_ = -problem.g;
  H_.matrixL().solveInPlace(w_);
  return true;
}

bool ActiveConstraints::start_equalities(const RowMatrix& A, const Eigen::VectorXd& b) noexcept {
  count_ = A.rows();
  if (count_ == 0) return true;
  if (count_ > V_.cols()) return false;
  auto V = V_.leftCols(count_);
  V = A.transpose();
  H_.matrixL().solveInPlace(V);
  auto R = R_.topLeftCorner(count_, count_);
  R.noalias() = V.transpose() * V;
  // Zero rows (written for a soft foot) get a unit pivot. The multiplier of such a row is zero, and
  // the row affects no other row.
  for (Eigen::Index k = 0; k < count_; ++k) {
    if (R(k, k) == 0.0) R(k, k) = 1.0;
  }
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> in_place(R);
  for (Eigen::Index k = 0; k < count_; ++k)
    rows_[static_cast<std::size_t>(k)] = static_cast<int>(k);
  sides_.head(count_).setOnes();
  bounds_.head(count_) = b;
  return in_place.info() == Eigen::Success;
}

void ActiveConstraints::project_column() noexcept {
  H_.matrixL().solveInPlace(v_);
  auto l = l_.head(count_);
  auto direction = dual_direction_.head(count_);
  const auto R = R_.topLeftCorner(count_, count_);
  l.noalias() = V_.leftCols(count_).transpose() * v_;
  R.triangularView<Eigen::Lower>().solveInPlace(l);
  squared_residual_ = v_.squaredNorm() - l.squaredNorm();
  direction = l;
  R.transpose().triangularView<Eigen::Upper>().solveInPlace(direction);
}

bool ActiveConstraints::is_dependent() const noexcept {
  return !(squared_residual_ > kMinIndependent * v_.squaredNorm());
}

double ActiveConstraints::residual_norm() noexcept {
  v_.noalias() -= V_.leftCols(count_) * dual_direction_.head(count_);
  return v_.norm();
}

bool ActiveConstraints::append(int row, double side, double bound, double multiplier) noexcept {
  if (count_ == V_.cols() || is_dependent()) return false;
  rows_[static_cast<std::size_t>(count_)] = row;
  sides_[count_] = side;
  bounds_[count_] = bound;
  multipliers_[count_] = multiplier;
  V_.col(count_) = v_;
  R_.row(count_).head(count_) = l_.head(count_);
  R_(count_, count_) = std::sqrt(squared_residual_);
  ++count_;
  return true;
}

void ActiveConstraints::remove(Eigen::Index removed) noexcept {
  for (Eigen::Index k = removed; k + 1 < count_; ++k) {
    rows_[static_cast<std::size_t>(k)] = row(k + 1);
    sides_[k] = sides_[k + 1];
    bounds_[k] = bounds_[k + 1];
    multipliers_[k] = multipliers_[k + 1];
    V_.col(k) = V_.col(k + 1);
  }
  --count_;
  factorise(removed);
}

// Compute the rows of R from row `from` on, after columns of V have changed.
// The bound 1e-300 avoids the square root of a negative rounding error, and a division by zero
// later.
void ActiveConstraints::factorise(Eigen::Index from) noexcept {
  for (Eigen::Index k = from; k < count_; ++k) {
    auto l = l_.head(k);
    l.noalias() = V_.leftCols(k).transpose() * V_.col(k);
    R_.topLeftCorner(k, k).triangularView<Eigen::Lower>().solveInPlace(l);
    R_.row(k).head(k) = l;
    R_(k, k) = std::sqrt(std::max(V_.col(k).squaredNorm() - l.squaredNorm(), 1e-300));
  }
}

void ActiveConstraints::solve_multipliers() noexcept {
  auto m = multipliers_.head(count_);
  const auto R = R_.topLeftCorner(count_, count_);
  m.noalias() = V_.leftCols(count_).transpose() * w_;
  m -= bounds_.head(count_);
  R.triangularView<Eigen::Lower>().solveInPlace(m);
  R.transpose().triangularView<Eigen::Upper>().solveInPlace(m);
}

const Eigen::VectorXd& ActiveConstraints::solve_x() noexcept {
  x_ = w_;
  x_.noalias() -= V_.leftCols(count_) * multipliers_.head(count_);
  H_.matrixU().solveInPlace(x_);
  return x_;
}

}  // namespace surefoot
