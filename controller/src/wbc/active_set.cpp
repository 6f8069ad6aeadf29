// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/active_set.hpp"

#include <cmath>
#include <limits>

namespace surefoot {

namespace {

constexpr double kDependent = 1e-9;  // of a row's squared length: less than that is new in it
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kShare = 0.1;  // of the tolerance: violated

}  // namespace

ActiveSet::ActiveSet(int n, int n_in)
    : n_(n),
      n_in_(n_in),
      H_(n),
      free_(Eigen::VectorXd::Zero(n)),
      rows_(static_cast<std::size_t>(n), 0),
      sides_(free_),
      bounds_(free_),
      multipliers_(free_),
      V_(Eigen::MatrixXd::Zero(n, n)),
      R_(V_),
      x_(free_),
      Cx_(Eigen::VectorXd::Zero(n_in)),
      v_(free_),
      l_(free_),
      step_(free_) {}

ActiveSet::Outcome ActiveSet::solve(const QpProblem& problem, double tolerance, Eigen::VectorXd& x,
                                    Eigen::VectorXd& z) noexcept {
  changes_ = 0;
  if (!begin(problem, z)) return Outcome::kGaveUp;
  drop_pulling_rows();
  for (;;) {
    const Violation violation = worst(problem, kShare * tolerance);
    if (violation.row == kNotFinite) return Outcome::kGaveUp;
    if (violation.row == kNone) break;
    const Outcome added = add(problem, violation);
    if (added != Outcome::kSolved) return added;
  }
  x = x_;
  z.setZero();
  for (Eigen::Index k = 0; k < count_; ++k) z[rows_[k]] = sides_[k] * multipliers_[k];
  return Outcome::kSolved;
}

bool ActiveSet::begin(const QpProblem& problem, const Eigen::VectorXd& z) noexcept {
  count_ = 0;
  if (!problem.H.allFinite()) return false;  // half of it would not be looked at
  H_.compute(problem.H);
  if (H_.info() != Eigen::Success) return false;
  free_ = -problem.g;
  H_.matrixL().solveInPlace(free_);
  for (int row = 0; row < n_in_; ++row) {
    if (z[row] == 0.0) continue;
    const double side = z[row] > 0.0 ? 1.0 : -1.0;
    const double bound = side * (side > 0.0 ? problem.u[row] : problem.l[row]);
    if (!(std::abs(bound) < kNoBound)) continue;
    direct(problem, row, side);
    append(row, side, bound, 0.0);  // what depends on the rows before is left out
  }
  return true;
}

// Until every multiplier pushes, the rows are no set that the method can begin with.
void ActiveSet::drop_pulling_rows() noexcept {
  while (count_ > 0) {
    solve_multipliers();
    Eigen::Index worst = 0;
    if (multipliers_.head(count_).minCoeff(&worst) >= 0.0) return;
    remove(worst);
    ++changes_;
  }
}

// With w = free_: V'V m = V'w - b.
void ActiveSet::solve_multipliers() noexcept {
  auto m = multipliers_.head(count_);
  const auto R = R_.topLeftCorner(count_, count_);
  m.noalias() = V_.leftCols(count_).transpose() * free_;
  m -= bounds_.head(count_);
  R.triangularView<Eigen::Lower>().solveInPlace(m);
  R.transpose().triangularView<Eigen::Upper>().solveInPlace(m);
}

// x = L'^-1 (w - V m), and where it is furthest outside.
ActiveSet::Violation ActiveSet::worst(const QpProblem& problem, double tolerance) noexcept {
  x_ = free_;
  x_.noalias() -= V_.leftCols(count_) * multipliers_.head(count_);
  H_.matrixU().solveInPlace(x_);
  Cx_.noalias() = problem.C * x_;
  Violation found;
  found.amount = tolerance;
  for (int row = 0; row < n_in_; ++row) {
    const double above = Cx_[row] - problem.u[row], below = problem.l[row] - Cx_[row];
    if (std::isnan(above) || std::isnan(below)) return {kNotFinite, 0.0, 0.0};
    if (above > found.amount) found = {row, 1.0, above};
    if (below > found.amount) found = {row, -1.0, below};
  }
  return found;
}

// Move towards the row until it holds, or until another row's multiplier is used up: that one goes.
ActiveSet::Outcome ActiveSet::add(const QpProblem& problem, Violation violation) noexcept {
  const auto [row, side, amount] = violation;
  const double bound = side * (side > 0.0 ? problem.u[row] : problem.l[row]);
  double missing = amount, multiplier = 0.0;
  for (;;) {
    if (++changes_ > kMostChanges) return Outcome::kGaveUp;
    direct(problem, row, side);
    const bool dependent = !(length_ > kDependent * v_.squaredNorm());
    double length = dependent ? kInfinite : missing / length_;
    Eigen::Index blocking = -1;
    for (Eigen::Index k = 0; k < count_; ++k) {
      if (step_[k] * length > multipliers_[k] && step_[k] > 0.0) {
        length = multipliers_[k] / step_[k];
        blocking = k;
      }
    }
    if (!(length < kInfinite)) return Outcome::kInfeasible;
    multipliers_.head(count_) -= length * step_.head(count_);
    multiplier += length;
    if (blocking < 0) {
      return append(row, side, bound, multiplier) ? Outcome::kSolved : Outcome::kGaveUp;
    }
    if (!dependent) missing -= length * length_;
    remove(blocking);
  }
}

void ActiveSet::direct(const QpProblem& problem, int row, double side) noexcept {
  v_ = side * problem.C.row(row);
  H_.matrixL().solveInPlace(v_);
  auto l = l_.head(count_);
  auto step = step_.head(count_);
  const auto R = R_.topLeftCorner(count_, count_);
  l.noalias() = V_.leftCols(count_).transpose() * v_;
  R.triangularView<Eigen::Lower>().solveInPlace(l);
  length_ = v_.squaredNorm() - l.squaredNorm();
  step = l;
  R.transpose().triangularView<Eigen::Upper>().solveInPlace(step);
}

// What direct() looked at becomes active.
bool ActiveSet::append(int row, double side, double bound, double multiplier) noexcept {
  if (count_ == n_ || !(length_ > kDependent * v_.squaredNorm())) return false;
  rows_[count_] = row;
  sides_[count_] = side;
  bounds_[count_] = bound;
  multipliers_[count_] = multiplier;
  V_.col(count_) = v_;
  R_.row(count_).head(count_) = l_.head(count_);
  R_(count_, count_) = std::sqrt(length_);
  ++count_;
  return true;
}

void ActiveSet::remove(Eigen::Index gone) noexcept {
  for (Eigen::Index k = gone; k + 1 < count_; ++k) {
    rows_[k] = rows_[k + 1];
    sides_[k] = sides_[k + 1];
    bounds_[k] = bounds_[k + 1];
    multipliers_[k] = multipliers_[k + 1];
    V_.col(k) = V_.col(k + 1);
  }
  --count_;
  factorise();
}

void ActiveSet::factorise() noexcept {
  for (Eigen::Index k = 0; k < count_; ++k) {
    auto l = l_.head(k);
    l.noalias() = V_.leftCols(k).transpose() * V_.col(k);
    R_.topLeftCorner(k, k).triangularView<Eigen::Lower>().solveInPlace(l);
    R_.row(k).head(k) = l;
    R_(k, k) = std::sqrt(std::max(V_.col(k).squaredNorm() - l.squaredNorm(), 1e-300));
  }
}

}  // namespace surefoot
