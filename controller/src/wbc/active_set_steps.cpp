// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/active_set_steps.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

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
      factor_row_(Eigen::VectorXd::Zero(n)),
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
  if (n_eq_ == 0) return true;
  auto W = W_.leftCols(n_eq_);
  W = problem.A.transpose();
  L_.triangularView<Eigen::Lower>().solveInPlace(W);
  auto S = S_.topLeftCorner(n_eq_, n_eq_);
  S.noalias() = W.transpose() * W;
  Eigen::Ref<Eigen::MatrixXd> factor(S);
  return InPlace(factor).info() == Eigen::Success;
}

// With N = (A', active rows of C') and d the bounds that these lie on:
//   x = -H^-1 (g + N m),  N'x = d,  so  N'H^-1 N m = -(d + N'H^-1 g)
// Rows that follow from those before them are left out: where a foot carries nothing, all sides of
// its friction cone meet.
void ActiveSetSteps::step(const QpProblem& problem) noexcept {
  m_.head(n_eq_) = -problem.b;
  int rows = n_eq_;
  for (const Active a : active_) {
    if (!add(problem.C.row(a.row).transpose(), rows)) continue;
    m_[rows] = a.upper ? -problem.u[a.row] : -problem.l[a.row];
    active_[rows++ - n_eq_] = a;
  }
  active_.resize(rows - n_eq_);
  auto m = m_.head(rows);
  const auto W = W_.leftCols(rows);
  const auto factor = S_.topLeftCorner(rows, rows).triangularView<Eigen::Lower>();
  x_ = -r_;
  if (rows > 0) {
    m.noalias() -= W.transpose() * r_;
    factor.solveInPlace(m);
    factor.transpose().solveInPlace(m);
    x_.noalias() -= W * m;
  }
  L_.triangularView<Eigen::Lower>().transpose().solveInPlace(x_);
  y_ = m_.head(n_eq_);
  z_.setZero();
  for (int k = n_eq_; k < rows; ++k) z_[active_[k - n_eq_].row] = m_[k];
}

// One more column of W and row of the Cholesky factor of W'W.
template <typename Row>
bool ActiveSetSteps::add(const Row& normal, int rows) noexcept {
  if (rows == n_) return false;
  auto w = W_.col(rows);
  w = normal;
  L_.triangularView<Eigen::Lower>().solveInPlace(w);
  const double square = w.squaredNorm();
  auto f = factor_row_.head(rows);
  f.noalias() = W_.leftCols(rows).transpose() * w;
  S_.topLeftCorner(rows, rows).triangularView<Eigen::Lower>().solveInPlace(f);
  const double pivot = square - f.squaredNorm();
  if (!(pivot > kIndependent * square)) return false;
  S_.row(rows).head(rows) = f.transpose();
  S_(rows, rows) = std::sqrt(pivot);
  return true;
}

// One row at a time: all that are beyond their bounds at once are far more than will be active, and
// the exchange then seldom ends.
bool ActiveSetSteps::guess(const QpProblem& problem, const Eigen::VectorXd& Cx,
                           double tolerance) noexcept {
  const auto pulls = [&](const Active& a) {
    const bool wrong = a.upper ? z_[a.row] < 0.0 : z_[a.row] > 0.0;
    return wrong && problem.u[a.row] - problem.l[a.row] > tolerance;  // else it is an equality
  };
  const auto kept = std::remove_if(active_.begin(), active_.end(), pulls);
  const bool dropped = kept != active_.end();
  active_.erase(kept, active_.end());
  if (dropped) return true;

  Active worst{-1, false};
  double most = tolerance;
  for (int i = 0; i < Cx.size(); ++i) {
    const double above = Cx[i] - problem.u[i], below = problem.l[i] - Cx[i];
    if (!(std::max(above, below) > most)) continue;
    most = std::max(above, below);
    worst = {i, above > below};
  }
  if (worst.row >= 0) active_.push_back(worst);
  return worst.row >= 0;
}

}  // namespace surefoot
