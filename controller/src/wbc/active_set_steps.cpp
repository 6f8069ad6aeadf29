// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/active_set_steps.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace surefoot {

namespace {

// Squared sine of the angle between a row and those before it, in the metric of H: below, its
// multiplier is arbitrary.
constexpr double kIndependent = 1e-8;
constexpr double kResidue = 1e-12;  // smaller multipliers are rounding

using InPlace = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

}  // namespace

ActiveSetSteps::ActiveSetSteps(int n, int n_eq, int n_in)
    : n_(n),
      n_eq_(n_eq),
      L_(Eigen::MatrixXd::Zero(n, n)),
      W_(Eigen::MatrixXd::Zero(n, n)),
      S_(Eigen::MatrixXd::Zero(n, n)),
      r_(Eigen::VectorXd::Zero(n)),
      m_(Eigen::VectorXd::Zero(n)),
      diagonal_(Eigen::VectorXd::Zero(n)),
      x_(Eigen::VectorXd::Zero(n)),
      y_(Eigen::VectorXd::Zero(n_eq)),
      z_(Eigen::VectorXd::Zero(n_in)) {
  active_.reserve(n_in);
}

bool ActiveSetSteps::start(const QpProblem& problem, const Eigen::VectorXd& multipliers) noexcept {
  active_.clear();
  for (int i = 0; i < multipliers.size(); ++i) {
    if (std::abs(multipliers[i]) > kResidue) active_.push_back({i, multipliers[i] > 0.0});
  }
  L_ = problem.H;
  Eigen::Ref<Eigen::MatrixXd> L(L_);
  if (n_eq_ > n_ || InPlace(L).info() != Eigen::Success) return false;
  r_ = problem.g;
  L_.triangularView<Eigen::Lower>().solveInPlace(r_);
  if (n_eq_ > 0) {
    auto equalities = W_.leftCols(n_eq_);
    equalities = problem.A.transpose();
    L_.triangularView<Eigen::Lower>().solveInPlace(equalities);
  }
  return true;
}

// With N = (A', active rows of C') and d the bounds that these lie on:
//   x = -H^-1 (g + N m),  N'x = d,  so  N'H^-1 N m = -(d + N'H^-1 g)
bool ActiveSetSteps::step(const QpProblem& problem) noexcept {
  const int rows = n_eq_ + static_cast<int>(active_.size());
  if (rows > n_) return false;
  m_.head(n_eq_) = -problem.b;
  for (int k = n_eq_; k < rows; ++k) {
    const auto [row, upper] = active_[k - n_eq_];
    m_[k] = upper ? -problem.u[row] : -problem.l[row];
    auto column = W_.col(k);
    column = problem.C.row(row).transpose();
    L_.triangularView<Eigen::Lower>().solveInPlace(column);
  }
  if (rows > 0 && !solve_multipliers(rows)) return false;
  y_ = m_.head(n_eq_);
  z_.setZero();
  for (int k = n_eq_; k < rows; ++k) z_[active_[k - n_eq_].row] = m_[k];
  x_ = -r_;
  if (rows > 0) x_.noalias() -= W_.leftCols(rows) * m_.head(rows);
  L_.triangularView<Eigen::Lower>().transpose().solveInPlace(x_);
  return true;
}

bool ActiveSetSteps::solve_multipliers(int rows) noexcept {
  const auto W = W_.leftCols(rows);
  auto m = m_.head(rows);
  m.noalias() -= W.transpose() * r_;
  auto S = S_.topLeftCorner(rows, rows);
  S.noalias() = W.transpose() * W;
  diagonal_.head(rows) = S.diagonal();
  Eigen::Ref<Eigen::MatrixXd> factor(S);
  const InPlace cholesky(factor);
  if (cholesky.info() != Eigen::Success) return false;
  if (!(S.diagonal().array().square() > kIndependent * diagonal_.head(rows).array()).all()) {
    return false;
  }
  cholesky.solveInPlace(m);
  return true;
}

bool ActiveSetSteps::guess(const QpProblem& problem, const Eigen::VectorXd& Cx,
                           double tolerance) noexcept {
  // An active row's bound is met, so that it cannot be found beyond it below.
  const std::size_t before = active_.size();
  const auto pulls = [&](Active& a) {
    const bool wrong = a.upper ? z_[a.row] < 0.0 : z_[a.row] > 0.0;
    return wrong && problem.u[a.row] - problem.l[a.row] > tolerance;
  };
  active_.erase(std::remove_if(active_.begin(), active_.end(), pulls), active_.end());
  bool changed = active_.size() != before;
  for (int i = 0; i < Cx.size(); ++i) {
    const bool above = Cx[i] > problem.u[i] + tolerance;
    if (!above && !(Cx[i] < problem.l[i] - tolerance)) continue;
    active_.push_back({i, above});
    changed = true;
  }
  return changed;
}

}  // namespace surefoot
