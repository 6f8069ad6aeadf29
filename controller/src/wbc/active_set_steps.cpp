// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/active_set_steps.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

// Squared sine of the angle between a row and those before it, in the metric of H: below, its
// multiplier is arbitrary.
constexpr double kIndependent = 1e-8;
constexpr double kResidue = 1e-12;  // smaller multipliers are rounding
constexpr double kThin = 1e-9;      // rows whose bounds are nearer than this are equalities
constexpr int kExchanges = 120;     // rows dropped or traded from start on

using InPlace = Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>;

}  // namespace

ActiveSetSteps::ActiveSetSteps(int n, int n_eq, int n_in)
    : n_(n),
      n_eq_(n_eq),
      L_(Eigen::MatrixXd::Zero(n, n)),
      W_(Eigen::MatrixXd::Zero(n, n + 1)),
      S_(Eigen::MatrixXd::Zero(n, n)),
      r_(Eigen::VectorXd::Zero(n)),
      m_(Eigen::VectorXd::Zero(n_eq + n_in + 1)),
      target_(Eigen::VectorXd::Zero(n)),
      factor_row_(Eigen::VectorXd::Zero(n)),
      x_(Eigen::VectorXd::Zero(n)),
      y_(Eigen::VectorXd::Zero(n_eq)),
      z_(Eigen::VectorXd::Zero(n_in)) {
  active_.reserve(n_in + 1);
}

bool ActiveSetSteps::start(const QpProblem& problem, const Eigen::VectorXd& multipliers) noexcept {
  active_.clear();
  entering_ = false;
  exchanges_ = 0;
  factored_ = n_eq_;
  m_.head(n_eq_).setZero();
  for (int i = 0; i < multipliers.size(); ++i) {
    if (!(std::abs(multipliers[i]) > kResidue)) continue;
    m_[count()] = multipliers[i];
    active_.push_back({i, multipliers[i] > 0.0 ? 1.0 : -1.0});
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
bool ActiveSetSteps::step(const QpProblem& problem) noexcept {
  if (!settle(problem)) return false;
  x_ = -r_;
  if (count() > 0) x_.noalias() -= W_.leftCols(count()) * m_.head(count());
  L_.triangularView<Eigen::Lower>().transpose().solveInPlace(x_);
  y_ = m_.head(n_eq_);
  z_.setZero();
  for (int k = n_eq_; k < count(); ++k) z_[active_[k - n_eq_].row] = m_[k];
  return true;
}

bool ActiveSetSteps::enter(const QpProblem& problem, const Eigen::VectorXd& Cx,
                           double tolerance) noexcept {
  double most = tolerance;
  Active worst{-1, 0.0};
  for (int i = 0; i < Cx.size(); ++i) {
    const double above = Cx[i] - problem.u[i], below = problem.l[i] - Cx[i];
    if (!(std::max(above, below) > most)) continue;
    most = std::max(above, below);
    worst = {i, above > below ? 1.0 : -1.0};
  }
  if (worst.row < 0) return false;
  m_[count()] = 0.0;
  active_.push_back(worst);
  entering_ = true;
  return true;
}

// The multipliers go towards those that the active rows ask for, until a row would pull: that one
// is dropped, and the others go on. The dual cost falls all the way, which is why this ends.
bool ActiveSetSteps::settle(const QpProblem& problem) noexcept {
  for (; exchanges_ <= kExchanges; ++exchanges_) {
    const Factored factored = factor(problem);
    if (factored == Factored::kInfeasible) return false;
    if (factored == Factored::kTraded) continue;
    solve_multipliers(problem);
    const int blocking = move_multipliers(problem);
    if (blocking < 0) {
      entering_ = false;
      return true;
    }
    for (int k = blocking; k + 1 < count(); ++k) m_[k] = m_[k + 1];
    entering_ = entering_ && blocking + 1 < count();
    factored_ = std::min(factored_, blocking);
    active_.erase(active_.begin() + (blocking - n_eq_));
  }
  return false;
}

// Rows that follow from those before them are left out, or, if new, take the place of another:
// where a foot carries nothing, all sides of its friction cone meet.
ActiveSetSteps::Factored ActiveSetSteps::factor(const QpProblem& problem) noexcept {
  int kept = factored_;
  for (int k = factored_; k < count(); ++k) {
    const Active a = active_[k - n_eq_];
    if (!add(problem, a.row, kept)) {
      if (!entering_ || k + 1 < count()) continue;
      active_.resize(kept - n_eq_);
      return trade(a, kept) ? Factored::kTraded : Factored::kInfeasible;
    }
    m_[kept] = m_[k];
    active_[kept++ - n_eq_] = a;
  }
  active_.resize(kept - n_eq_);
  factored_ = kept;
  return Factored::kAll;
}

// One more column of W and row of the Cholesky factor of W'W.
bool ActiveSetSteps::add(const QpProblem& problem, int row, int count) noexcept {
  auto w = W_.col(count);
  w = problem.C.row(row).transpose();
  L_.triangularView<Eigen::Lower>().solveInPlace(w);
  const double square = w.squaredNorm();
  auto f = factor_row_.head(count);
  f.noalias() = W_.leftCols(count).transpose() * w;
  S_.topLeftCorner(count, count).triangularView<Eigen::Lower>().solveInPlace(f);
  const double pivot = square - f.squaredNorm();
  if (count == n_ || !(pivot > kIndependent * square)) return false;
  S_.row(count).head(count) = f.transpose();
  S_(count, count) = std::sqrt(pivot);
  return true;
}

// The entering row is a sum of active ones: its multiplier grows at the cost of theirs, x stays
// where it is, and the first of them that would pull makes room. If none does, no x satisfies all.
bool ActiveSetSteps::trade(Active entering, int count) noexcept {
  auto share = factor_row_.head(count);
  S_.topLeftCorner(count, count).triangularView<Eigen::Lower>().transpose().solveInPlace(share);
  double most = std::numeric_limits<double>::infinity();
  int place = -1;
  for (int k = n_eq_; k < count; ++k) {
    const double falls = active_[k - n_eq_].side * entering.side * share[k];
    if (!(falls > kResidue)) continue;
    const double until = std::abs(m_[k]) / falls;
    if (!(until < most)) continue;
    most = until;
    place = k;
  }
  if (place < 0) return false;
  m_.head(count) -= (entering.side * most) * share;
  m_[place] = entering.side * most;
  active_[place - n_eq_] = entering;
  factored_ = place;
  entering_ = false;
  return true;
}

void ActiveSetSteps::solve_multipliers(const QpProblem& problem) noexcept {
  if (count() == 0) return;
  auto target = target_.head(count());
  target.head(n_eq_) = -problem.b;
  for (int k = n_eq_; k < count(); ++k) {
    const auto [row, side] = active_[k - n_eq_];
    target[k] = side > 0.0 ? -problem.u[row] : -problem.l[row];
  }
  target.noalias() -= W_.leftCols(count()).transpose() * r_;
  const auto factor = S_.topLeftCorner(count(), count()).triangularView<Eigen::Lower>();
  factor.solveInPlace(target);
  factor.transpose().solveInPlace(target);
}

// Returns the row that would pull first, -1 if none does.
int ActiveSetSteps::move_multipliers(const QpProblem& problem) noexcept {
  double fraction = 1.0;
  int blocking = -1;
  for (int k = n_eq_; k < count(); ++k) {
    const auto [row, side] = active_[k - n_eq_];
    if (side * target_[k] >= 0.0 || problem.u[row] - problem.l[row] < kThin) continue;
    const double now = std::max(side * m_[k], 0.0);
    const double until = now / (now - side * target_[k]);
    if (blocking >= 0 && until >= fraction) continue;
    fraction = until;
    blocking = k;
  }
  m_.head(count()) += fraction * (target_.head(count()) - m_.head(count()));
  return blocking;
}

}  // namespace surefoot
