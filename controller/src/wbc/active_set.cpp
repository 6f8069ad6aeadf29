// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/active_set.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// Rows at the tip of a friction cone depend on each other: this picks one of their multipliers, and
// moves the answer off its bounds by as much times the multiplier.
constexpr double kSoftness = 1e-10;

}  // namespace

ActiveSet::ActiveSet(int n, int n_in)
    : n_(n),
      n_in_(n_in),
      most_(std::min(2 * n, n_in)),
      side_(static_cast<std::size_t>(n_in), 0),
      H_(n),
      V_(Eigen::MatrixXd::Zero(n, most_)),
      S_(Eigen::MatrixXd::Zero(most_, most_)),
      free_(Eigen::VectorXd::Zero(n)),
      x_(free_),
      rhs_(Eigen::VectorXd::Zero(most_)),
      multipliers_(rhs_),
      Cx_(Eigen::VectorXd::Zero(n_in)) {
  active_.reserve(static_cast<std::size_t>(most_));
}

bool ActiveSet::solve(const QpProblem& problem, double tolerance, Eigen::VectorXd& x,
                      Eigen::VectorXd& z) noexcept {
  if (!begin(problem, z)) return false;
  for (rounds_ = 1; rounds_ <= kRounds; ++rounds_) {
    if (!solve_active(problem)) return false;
    if (!settle(problem, tolerance)) continue;
    x = x_;
    z.setZero();
    for (std::size_t k = 0; k < active_.size(); ++k) z[active_[k]] = multipliers_[k];
    return true;
  }
  return false;
}

bool ActiveSet::begin(const QpProblem& problem, const Eigen::VectorXd& z) noexcept {
  for (int row = 0; row < n_in_; ++row) side_[row] = z[row] > 0.0 ? 1 : z[row] < 0.0 ? -1 : 0;
  H_.compute(problem.H);
  if (H_.info() != Eigen::Success) return false;
  free_ = -problem.g;
  H_.matrixL().solveInPlace(free_);
  return true;
}

// H x + g + Ca' z = 0 and Ca x = ba, for the active rows Ca: with V = L^-1 Ca', w = -L^-1 g it is
// V'V z = V'w - ba and x = L^-T (w - V z).
bool ActiveSet::solve_active(const QpProblem& problem) noexcept {
  active_.clear();
  for (int row = 0; row < n_in_; ++row) {
    if (side_[row] == 0) continue;
    if (static_cast<int>(active_.size()) == most_) return false;
    const auto k = static_cast<Eigen::Index>(active_.size());
    active_.push_back(row);
    V_.col(k) = problem.C.row(row);
    rhs_[k] = side_[row] > 0 ? problem.u[row] : problem.l[row];
    if (!(std::abs(rhs_[k]) < kNoBound)) return false;
  }
  const auto count = static_cast<Eigen::Index>(active_.size());
  x_ = free_;
  if (count > 0) {
    auto V = V_.leftCols(count);
    H_.matrixL().solveInPlace(V);
    auto z = multipliers_.head(count);
    z.noalias() = V.transpose() * free_;
    z -= rhs_.head(count);
    auto S = S_.topLeftCorner(count, count);
    S.noalias() = V.transpose() * V;
    S.diagonal().array() += kSoftness;
    Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> schur(S);
    if (schur.info() != Eigen::Success) return false;
    schur.solveInPlace(z);
    x_.noalias() -= V * z;
  }
  H_.matrixU().solveInPlace(x_);
  return true;
}

// Drop what pulls, take in what is violated. Did nothing change?
bool ActiveSet::settle(const QpProblem& problem, double tolerance) noexcept {
  bool settled = true;
  for (std::size_t k = 0; k < active_.size(); ++k) {
    if (multipliers_[k] * side_[active_[k]] >= 0.0) continue;
    side_[active_[k]] = 0;
    settled = false;
  }
  Cx_.noalias() = problem.C * x_;
  for (int row = 0; row < n_in_; ++row) {
    // (So that NaN counts as violated.)
    if (Cx_[row] <= problem.u[row] + tolerance && Cx_[row] >= problem.l[row] - tolerance) continue;
    const signed char side = Cx_[row] < problem.l[row] ? -1 : 1;
    if (side_[row] == side) return false;  // rows that cannot all hold
    side_[row] = side;
    settled = false;
  }
  return settled;
}

}  // namespace surefoot
