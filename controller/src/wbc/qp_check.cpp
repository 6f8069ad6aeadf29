// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_check.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

constexpr double kAccept = 5.0;  // times the tolerance

// A sum that only what is not finite takes away from zero; allFinite() goes entry by entry and
// takes several times as long.
template <typename Values>
bool is_finite(const Values& values) {
  return (values.array() * 0.0).sum() == 0.0;
}

// Without an early way out, so that it is vectorised.
bool has_nan(const Eigen::VectorXd& values) {
  bool found = false;
  for (Eigen::Index i = 0; i < values.size(); ++i) found |= !(values[i] == values[i]);
  return found;
}

}  // namespace

bool QpCheck::finite(const QpProblem& p) noexcept {
  // NaN in l or u would silently drop that bound inside ProxQP; infinities are allowed there.
  return is_finite(p.H) && is_finite(p.g) && is_finite(p.A) && is_finite(p.b) && is_finite(p.C) &&
         !has_nan(p.l) && !has_nan(p.u);
}

QpCheck::QpCheck(int n, int n_eq, int n_in)
    : Ax_(Eigen::VectorXd::Zero(n_eq)),
      Cx_(Eigen::VectorXd::Zero(n_in)),
      gradient_(Eigen::VectorXd::Zero(n)) {}

// A multiplier on a side that has no bound is wrong by its whole size.
// Beyond one a multiplier says no more than that its row must lie on the bound.
double QpCheck::row_gap(double z, double Cx, double l, double u) noexcept {
  const double bound = z > 0.0 ? u : l;
  return std::min(std::abs(z), 1.0) * (std::abs(bound) < kNoBound ? std::abs(bound - Cx) : 1.0);
}

// Our own residuals on the program as we posed it; the solver's word decides nothing.
QpResult QpCheck::operator()(const QpProblem& problem, const Eigen::VectorXd& x,
                             const Eigen::VectorXd& y, const Eigen::VectorXd& z,
                             double tolerance) noexcept {
  Cx_.noalias() = problem.C * x;
  gradient_ = problem.g;
  gradient_.noalias() += problem.H * x;
  QpResult out;
  for (Eigen::Index i = 0; i < Cx_.size(); ++i) {
    if (z[i] == 0.0) continue;  // nearly all
    gradient_ += z[i] * problem.C.row(i).transpose();
    out.gap = std::max(out.gap, row_gap(z[i], Cx_[i], problem.l[i], problem.u[i]));
  }
  if (Ax_.size() > 0) {
    Ax_.noalias() = problem.A * x;
    gradient_.noalias() += problem.A.transpose() * y;
  }
  out.primal_residual = std::max({0.0, (problem.l - Cx_).maxCoeff(), (Cx_ - problem.u).maxCoeff()});
  if (Ax_.size() > 0) {
    out.primal_residual =
        std::max(out.primal_residual, (Ax_ - problem.b).lpNorm<Eigen::Infinity>());
  }
  out.dual_residual = gradient_.lpNorm<Eigen::Infinity>();
  const bool accepted = is_finite(x) && is_finite(y) && is_finite(z) &&
                        out.primal_residual <= kAccept * tolerance &&
                        out.dual_residual <= kAccept * tolerance && out.gap <= tolerance;
  out.status = accepted ? Status::kOk : Status::kMaxIterations;
  return out;
}

}  // namespace surefoot
