// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_check.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// Largest accepted residual, as a multiple of the tolerance. Chosen larger than 1, because each
// solver stops by its own residuals, which differ from the residuals computed here.
// docs/benchmarks/qp.md judges all solvers by the same limit, 5e-6.
constexpr double kMaxResidualFactor = 5.0;

// Zero times NaN or infinity is NaN, so one sum checks all entries. allFinite() tests each entry
// and takes several times as long.
template <typename Values>
bool is_finite(const Values& values) {
  return (values.array() * 0.0).sum() == 0.0;
}

// The loop has no early exit, so the compiler can vectorise it.
bool has_nan(const Eigen::VectorXd& values) {
  bool found = false;
  for (Eigen::Index i = 0; i < values.size(); ++i) found |= !(values[i] == values[i]);
  return found;
}

}  // namespace

bool QpCheck::finite(const QpProblem& p) noexcept {
  // ProxQP silently drops a bound that is NaN. Infinite bounds are allowed.
  return is_finite(p.H) && is_finite(p.g) && is_finite(p.A) && is_finite(p.b) && is_finite(p.C) &&
         !has_nan(p.l) && !has_nan(p.u);
}

QpCheck::QpCheck(int n, int n_eq, int n_in)
    : Ax_(Eigen::VectorXd::Zero(n_eq)),
      Cx_(Eigen::VectorXd::Zero(n_in)),
      gradient_(Eigen::VectorXd::Zero(n)) {}

// A nonzero multiplier on a side without a bound is an error; the gap is then |z|, at most 1. A
// multiplier larger than 1 counts as 1, because the size of a nonzero multiplier does not matter:
// the row must be on its bound.
double QpCheck::row_gap(double z, double Cx, double l, double u) noexcept {
  const double bound = z > 0.0 ? u : l;
  return std::min(std::abs(z), 1.0) * (std::abs(bound) < kNoBound ? std::abs(bound - Cx) : 1.0);
}

QpResult QpCheck::operator()(const QpProblem& problem, const Eigen::VectorXd& x,
                             const Eigen::VectorXd& y, const Eigen::VectorXd& z,
                             double tolerance) noexcept {
  Cx_.noalias() = problem.C * x;
  gradient_ = problem.g;
  gradient_.noalias() += problem.H * x;
  QpResult out;
  for (Eigen::Index i = 0; i < Cx_.size(); ++i) {
    if (z[i] == 0.0) continue;  // true for most rows
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
                        out.primal_residual <= kMaxResidualFactor * tolerance &&
                        out.dual_residual <= kMaxResidualFactor * tolerance && out.gap <= tolerance;
  out.status = accepted ? Status::kOk : Status::kMaxIterations;
  return out;
}

}  // namespace surefoot
