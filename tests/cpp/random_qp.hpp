// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/qp_problem.hpp"

/// Return the largest violation of the Karush-Kuhn-Tucker conditions, written from their
/// definition: stationarity, feasibility, signs and complementarity.
inline double kkt_residual(const surefoot::QpProblem& p, const Eigen::VectorXd& x,
                           const Eigen::VectorXd& y, const Eigen::VectorXd& z) {
  const Eigen::VectorXd gradient = p.H * x + p.g + p.A.transpose() * y + p.C.transpose() * z;
  double worst = gradient.cwiseAbs().maxCoeff();
  if (p.b.size() > 0) worst = std::max(worst, (p.A * x - p.b).cwiseAbs().maxCoeff());
  const Eigen::VectorXd Cx = p.C * x;
  for (Eigen::Index i = 0; i < Cx.size(); ++i) {
    worst = std::max({worst, Cx[i] - p.u[i], p.l[i] - Cx[i]});
    const double bound = z[i] > 0.0 ? p.u[i] : p.l[i];
    // A multiplier acts towards its own bound, and only if that bound exists.
    const bool bounded = std::abs(bound) < surefoot::kNoBound;
    worst = std::max(worst, std::abs(z[i]) * (bounded ? std::abs(bound - Cx[i]) : 1.0));
  }
  return worst;
}

/// A random strictly convex QP with x = 0 feasible, scaled as QpSolver requires: trace(H) = n.
struct RandomQp {
  surefoot::QpProblem problem;
  explicit RandomQp(int seed, int n = 12, int n_eq = 0, int n_in = 72) : problem(n, n_eq, n_in) {
    std::srand(static_cast<unsigned>(seed));
    const Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, n / 2);
    problem.H = A * A.transpose() + 0.05 * Eigen::MatrixXd::Identity(n, n);
    problem.H *= n / problem.H.trace();
    problem.g = 2.0 * Eigen::VectorXd::Random(n);
    problem.A = Eigen::MatrixXd::Random(n_eq, n);
    problem.C = Eigen::MatrixXd::Random(n_in, n);
    problem.l = -0.2 * Eigen::VectorXd::Ones(n_in) + 0.2 * Eigen::VectorXd::Random(n_in);
    problem.u = 0.3 * Eigen::VectorXd::Ones(n_in) + 0.2 * Eigen::VectorXd::Random(n_in);
    problem.l.head(n_in / 2).setConstant(-surefoot::kNoBound);
  }
};

/// A random QP whose Hessian has rank two plus `rest` times the identity, as heavy user tasks make
/// it.
inline surefoot::QpProblem ill_conditioned(int seed, double rest, int n = 12, int n_eq = 0,
                                           int n_in = 72) {
  surefoot::QpProblem p = RandomQp(seed, n, n_eq, n_in).problem;
  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(n, 2);
  p.H = A * A.transpose() + rest * Eigen::MatrixXd::Identity(n, n);
  p.H *= n / p.H.trace();
  p.g = 2.0 * p.H * Eigen::VectorXd::Random(n);
  return p;
}
