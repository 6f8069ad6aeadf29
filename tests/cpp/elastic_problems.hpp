// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/test/unit_test.hpp>

#include "random_qp.hpp"
#include "wbc/elastic_solver.hpp"

/// Random elastic QPs, and their solutions from the definition.
namespace elastic_problems {

using namespace surefoot;

constexpr int kN = 12, kRows = 60, kHard = 20, kGroups = 5;
constexpr double kCurvature = 0.5;

inline ElasticRows elastic_rows() {
  ElasticRows rows;
  rows.groups = kGroups;
  for (int row = 0; row < kRows; ++row) rows.group.push_back(row < kHard ? -1 : row % kGroups);
  return rows;
}

// Make a random QP. Odd seeds have two elastic rows that contradict each other.
inline QpProblem problem_of(int seed, int n_eq = 0) {
  RandomQp random(seed, kN, n_eq, kRows);
  if (seed % 2 != 0) {
    QpProblem& p = random.problem;
    const int row = kHard + seed % (kRows - kHard - 1);
    p.C.row(row + 1) = p.C.row(row);
    p.l[row + 1] = p.u[row] + 0.2;
    p.u[row + 1] = p.l[row + 1] + 0.5;
  }
  return random.problem;
}

// Write the QP with explicit slacks s: C x - s <= u, C x + s >= l, s >= 0. Every row appears twice,
// as in the definition.
inline QpProblem with_slacks(const QpProblem& p, const ElasticRows& rows,
                             const Eigen::VectorXd& penalty) {
  const int n = static_cast<int>(p.g.size()), n_in = static_cast<int>(rows.group.size());
  QpProblem e(n + rows.groups, static_cast<int>(p.b.size()), 2 * n_in + rows.groups);
  e.H.topLeftCorner(n, n) = p.H;
  e.H.diagonal().tail(rows.groups).setConstant(kCurvature);
  e.g << p.g, penalty;
  e.A.leftCols(n) = p.A;
  e.b = p.b;
  e.C.topLeftCorner(n_in, n) = e.C.middleRows(n_in, n_in).leftCols(n) = p.C;
  e.C.bottomRightCorner(rows.groups, rows.groups).setIdentity();
  e.l << Eigen::VectorXd::Constant(n_in, -kNoBound), p.l, Eigen::VectorXd::Zero(rows.groups);
  e.u << p.u, Eigen::VectorXd::Constant(n_in + rows.groups, kNoBound);
  for (int row = 0; row < n_in; ++row) {
    if (rows.group[row] < 0) continue;
    e.C(row, n + rows.group[row]) = -1.0;
    e.C(n_in + row, n + rows.group[row]) = 1.0;
  }
  return e;
}

// Solve the whole QP at the tightest tolerance that succeeds, and check the KKT conditions. The QP
// is strictly convex, so the solution is unique.
inline Eigen::VectorXd certified_solution(const QpProblem& e) {
  for (const double tolerance : {1e-9, 1e-8, 1e-7, 1e-6}) {
    QpSolver solver(static_cast<int>(e.g.size()), static_cast<int>(e.b.size()),
                    static_cast<int>(e.u.size()), tolerance);
    if (solver.solve(e).status != Status::kOk) continue;
    BOOST_REQUIRE(kkt_residual(e, solver.x(), solver.y(), solver.z()) < 10.0 * tolerance);
    return solver.x();
  }
  BOOST_FAIL("no certificate");
  return {};
}

}  // namespace elastic_problems
