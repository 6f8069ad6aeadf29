// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "random_qp.hpp"
#include "wbc/active_set.hpp"
#include "wbc/qp_solver.hpp"

using namespace surefoot;

namespace {

constexpr int kDefaultChanges = 100;  // limit of active-set changes; with 0, ProxQP solves

/// Solve a QP and check it. @return whether its active constraints differed from the last ones
bool solve_and_check(QpSolver& solver, const QpProblem& p, double tolerance) {
  const QpResult result = solver.solve(p);
  BOOST_TEST((result.status == Status::kOk));
  BOOST_TEST(kkt_residual(p, solver.x(), solver.y(), solver.z()) < 10.0 * tolerance);
  return result.iterations > 1;
}

/// Make a QP with rows through one vertex, duplicate rows and rows with equal bounds. x = 0
/// satisfies all of them.
QpProblem degenerate(int seed) {
  QpProblem p = RandomQp(seed).problem;
  p.u.tail(20).setZero();
  p.C.row(10) = p.C.row(11);
  p.u[10] = p.u[11];
  for (const int row : {60, 61, 62}) p.l[row] = p.u[row];
  return p;
}

/// Make a QP with pairs of nearly parallel rows.
QpProblem near_parallel(int seed) {
  QpProblem p = RandomQp(seed).problem;
  for (int row = 0; row < 20; row += 2) {
    p.C.row(row + 1) = p.C.row(row) + 1e-4 * Eigen::RowVectorXd::Random(12);
    p.u[row + 1] = p.u[row];
  }
  return p;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(qp_solver)

BOOST_AUTO_TEST_CASE(accepted_solutions_satisfy_kkt_for_both_methods_warm_and_cold) {
  for (const int max_changes : {kDefaultChanges, 0}) {
    QpSolver solver(12, 0, 72, 1e-6, max_changes);
    int more = 0;
    for (int seed = 0; seed < 300; ++seed) {
      more += solve_and_check(solver, RandomQp(seed).problem, 1e-6);
      if (seed % 10 == 0) solver.reset();
    }
    BOOST_TEST(more > 250);
  }
}

BOOST_AUTO_TEST_CASE(equality_constraints_satisfy_kkt_for_both_methods) {
  for (const int max_changes : {kDefaultChanges, 0}) {
    QpSolver solver(30, 18, 88, 1e-6, max_changes);
    int more = 0;
    for (int seed = 0; seed < 100; ++seed) {
      more += solve_and_check(solver, RandomQp(seed, 30, 18, 88).problem, 1e-6);
    }
    BOOST_TEST(more > 80);
  }
}

BOOST_AUTO_TEST_CASE(both_methods_meet_a_tolerance_of_1e_minus_12) {
  for (const int max_changes : {kDefaultChanges, 0}) {
    QpSolver solver(12, 0, 72, 1e-12, max_changes);
    for (int seed = 0; seed < 100; ++seed) {
      solve_and_check(solver, RandomQp(seed).problem, 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(degenerate_and_near_parallel_constraints_are_solved) {
  QpSolver solver(12, 0, 72, 1e-6);
  for (int seed = 0; seed < 100; ++seed) {
    solve_and_check(solver, degenerate(seed), 1e-6);
    solve_and_check(solver, near_parallel(seed), 1e-6);
  }
}

// ProxQP cannot solve some of them; it must refuse those.
BOOST_AUTO_TEST_CASE(proxqp_alone_solves_97_percent_of_degenerate_qps) {
  QpSolver solver(12, 0, 72, 1e-6, 0);
  int refused = 0;
  for (int seed = 0; seed < 200; ++seed) {
    const QpProblem p = seed % 2 == 0 ? degenerate(seed) : near_parallel(seed);
    if (solver.solve(p).status != Status::kOk) {
      ++refused;
      continue;
    }
    BOOST_TEST(kkt_residual(p, solver.x(), solver.y(), solver.z()) < 1e-5);
  }
  BOOST_TEST(refused <= 6);
}

BOOST_AUTO_TEST_CASE(both_methods_solve_an_ill_conditioned_cost) {
  for (const int max_changes : {kDefaultChanges, 0}) {
    QpSolver solver(12, 0, 72, 1e-6, max_changes);
    for (int seed = 0; seed < 100; ++seed) {
      solve_and_check(solver, ill_conditioned(seed, 1e-2), 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(reported_residuals_match_recomputed_residuals) {
  QpSolver solver(12, 0, 72, 1e-6);
  for (int seed = 0; seed < 50; ++seed) {
    const RandomQp random(seed);
    const QpProblem& p = random.problem;
    const QpResult result = solver.solve(p);
    const Eigen::VectorXd Cx = p.C * solver.x();
    const double violation = std::max({0.0, (p.l - Cx).maxCoeff(), (Cx - p.u).maxCoeff()});
    const Eigen::VectorXd gradient = p.H * solver.x() + p.g + p.C.transpose() * solver.z();
    BOOST_TEST(std::abs(result.primal_residual - violation) < 1e-12);
    BOOST_TEST(std::abs(result.dual_residual - gradient.cwiseAbs().maxCoeff()) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(nan_qp_is_refused_and_the_next_qp_is_solved) {
  QpSolver solver(12, 0, 72, 1e-6);
  for (int field = 0; field < 5; ++field) {
    RandomQp random(field);
    Eigen::VectorXd* vectors[] = {&random.problem.g, &random.problem.l, &random.problem.u};
    if (field < 3) (*vectors[field])[3] = std::nan("");
    if (field == 3) random.problem.H(1, 2) = std::nan("");
    if (field == 4) random.problem.C(1, 2) = std::numeric_limits<double>::infinity();
    BOOST_TEST((solver.solve(random.problem).status == Status::kNonFinite));
    BOOST_TEST((solver.solve(RandomQp(field).problem).status == Status::kOk));
  }
}

// An infeasible QP uses the whole budget of ProxQP, however many changes the active set made
// before.
BOOST_AUTO_TEST_CASE(active_set_changes_do_not_use_the_proxqp_iteration_budget) {
  QpSolver after_changes(12, 0, 72, 1e-6), at_once(12, 0, 72, 1e-6, 0);
  int changes = 0;
  for (int seed = 0; seed < 50; ++seed) {
    QpProblem p = RandomQp(seed).problem;
    p.C.row(70) = p.C.row(71);
    p.l[70] = p.u[71] + 1.0;
    p.u[70] = p.l[70] + 1.0;
    ActiveSet method(12, 0, 72);
    Eigen::VectorXd x, y, z = Eigen::VectorXd::Zero(72);
    BOOST_TEST((method.solve(p, 1e-6, x, y, z) == ActiveSet::Outcome::kInfeasible));
    after_changes.reset();
    at_once.reset();
    const int spent = after_changes.solve(p, 20).iterations - method.iterations();
    BOOST_TEST(spent == at_once.solve(p, 20).iterations - 1);
    changes += method.iterations() - 1;
  }
  BOOST_TEST(changes > 100);
}

// A warm start takes every row with a nonzero multiplier for active.
BOOST_AUTO_TEST_CASE(inactive_constraints_have_zero_multipliers) {
  for (const int max_changes : {kDefaultChanges, 0}) {
    QpSolver solver(12, 0, 72, 1e-9, max_changes);
    for (int seed = 0; seed < 100; ++seed) {
      solve_and_check(solver, RandomQp(seed).problem, 1e-9);
      BOOST_TEST((solver.z().array() != 0.0).count() <= 12);
    }
  }
}

BOOST_AUTO_TEST_CASE(contradictory_constraints_are_not_reported_as_solved) {
  QpSolver solver(12, 0, 72, 1e-6);
  RandomQp random(3);
  random.problem.C.row(70) = random.problem.C.row(71);
  random.problem.l[70] = random.problem.u[71] + 1.0;
  random.problem.u[70] = random.problem.l[70] + 1.0;
  BOOST_TEST((solver.solve(random.problem).status != Status::kOk));
  BOOST_TEST((solver.solve(RandomQp(3).problem).status == Status::kOk));
}

BOOST_AUTO_TEST_SUITE_END()
