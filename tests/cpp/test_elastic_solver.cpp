// SPDX-License-Identifier: BSD-3-Clause
// Compare ElasticSolver with the QP that has explicit slacks, solved to a certified accuracy.
#include "elastic_problems.hpp"

using namespace elastic_problems;

namespace {

double violation(const QpProblem& p, const Eigen::VectorXd& x, int row) {
  const double value = p.C.row(row).dot(x);
  return std::max({0.0, value - p.u[row], p.l[row] - value});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(elastic_solver)

BOOST_AUTO_TEST_CASE(elastic_solver_matches_the_explicit_slack_qp) {
  const ElasticRows rows = elastic_rows();
  const Eigen::VectorXd penalty = Eigen::VectorXd::LinSpaced(kGroups, 1.0, 10.0);
  for (const int n_eq : {0, 4}) {
    ElasticSolver solver(kN, n_eq, rows, 1e-6);
    int yielding = 0, hard_count = 0;
    for (int seed = 0; seed < 200; ++seed) {
      const QpProblem p = problem_of(seed, n_eq);
      BOOST_REQUIRE((solver.solve(p, penalty, kCurvature).status == Status::kOk));
      const Eigen::VectorXd best = certified_solution(with_slacks(p, rows, penalty));
      BOOST_TEST((solver.x() - best.head(kN)).norm() < 1e-3);
      BOOST_TEST((solver.slack() - best.tail(kGroups)).norm() < 1e-3);
      (best.tail(kGroups).maxCoeff() > 1e-4 ? yielding : hard_count) += 1;
      if (seed % 10 == 0) solver.reset();
    }
    BOOST_TEST(yielding >= 100);
    BOOST_TEST(hard_count >= 20);
  }
}

BOOST_AUTO_TEST_CASE(solutions_agree_to_1e_minus_6_at_a_tight_tolerance) {
  const ElasticRows rows = elastic_rows();
  const Eigen::VectorXd penalty = Eigen::VectorXd::Constant(kGroups, 1.0);
  ElasticSolver solver(kN, 0, rows, 1e-9);
  for (int seed = 0; seed < 100; ++seed) {
    const QpProblem p = problem_of(seed);
    BOOST_REQUIRE((solver.solve(p, penalty, kCurvature).status == Status::kOk));
    const Eigen::VectorXd best = certified_solution(with_slacks(p, rows, penalty));
    BOOST_TEST((solver.x() - best.head(kN)).norm() < 1e-6);
    BOOST_TEST((solver.slack() - best.tail(kGroups)).norm() < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(group_slack_is_its_largest_violation_and_hard_rows_hold) {
  const ElasticRows rows = elastic_rows();
  ElasticSolver solver(kN, 0, rows, 1e-10);
  for (int seed = 1; seed < 100; seed += 2) {
    const QpProblem p = problem_of(seed);
    BOOST_REQUIRE(
        (solver.solve(p, Eigen::VectorXd::Ones(kGroups), kCurvature).status == Status::kOk));
    Eigen::VectorXd worst = Eigen::VectorXd::Zero(kGroups);
    for (int row = 0; row < kHard; ++row) BOOST_TEST(violation(p, solver.x(), row) < 1e-8);
    for (int row = kHard; row < kRows; ++row) {
      double& group = worst[rows.group[row]];
      group = std::max(group, violation(p, solver.x(), row));
    }
    BOOST_TEST((worst - solver.slack()).cwiseAbs().maxCoeff() < 1e-7);
  }
}

// A penalty above the sum of a group's multipliers gives exactly the hard solution. With a smaller
// penalty the rows of the group are violated.
BOOST_AUTO_TEST_CASE(penalty_above_the_multiplier_sum_gives_the_hard_solution) {
  const ElasticRows rows = elastic_rows();
  int tried = 0;
  for (int seed = 0; seed < 60; seed += 2) {
    const QpProblem p = problem_of(seed);
    QpSolver hard(kN, 0, kRows, 1e-10);
    BOOST_REQUIRE((hard.solve(p).status == Status::kOk));
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(kGroups);
    for (int row = kHard; row < kRows; ++row) sum[rows.group[row]] += std::abs(hard.z()[row]);
    int group = 0;
    if (sum.maxCoeff(&group) < 0.1) continue;
    ++tried;
    Eigen::VectorXd penalty = 1.01 * sum.array() + 0.01;
    ElasticSolver high_penalty(kN, 0, rows, 1e-10), low_penalty(kN, 0, rows, 1e-10);
    BOOST_REQUIRE((high_penalty.solve(p, penalty, kCurvature).status == Status::kOk));
    BOOST_TEST((high_penalty.x() - hard.x()).norm() < 1e-7);
    BOOST_TEST(high_penalty.slack().maxCoeff() < 1e-8);
    BOOST_TEST(!high_penalty.elastic_mode());
    penalty[group] = 0.9 * sum[group];
    BOOST_REQUIRE((low_penalty.solve(p, penalty, kCurvature).status == Status::kOk));
    BOOST_TEST(low_penalty.slack()[group] > 1e-4);
    BOOST_TEST(low_penalty.elastic_mode());
  }
  BOOST_TEST(tried >= 20);
}

BOOST_AUTO_TEST_CASE(solver_returns_to_the_hard_qp_when_all_slacks_are_zero) {
  ElasticSolver solver(kN, 0, elastic_rows(), 1e-6);
  const Eigen::VectorXd penalty = Eigen::VectorXd::Constant(kGroups, 100.0);
  solver.solve(problem_of(1), penalty, kCurvature);
  BOOST_TEST(solver.elastic_mode());
  for (int k = 0; k < 30; ++k) solver.solve(problem_of(0), penalty, kCurvature);
  BOOST_TEST(!solver.elastic_mode());
  BOOST_TEST(solver.slack().maxCoeff() == 0.0);
}

BOOST_AUTO_TEST_CASE(elastic_mode_lasts_equally_long_each_time) {
  ElasticSolver solver(kN, 0, elastic_rows(), 1e-6);
  const auto ticks_yielding = [&] {
    const Eigen::VectorXd low = Eigen::VectorXd::Constant(kGroups, 1e-9);
    solver.solve(problem_of(1), low, kCurvature);
    int ticks = 0;
    for (; solver.elastic_mode() && ticks < 100; ++ticks) {
      solver.solve(problem_of(0), Eigen::VectorXd::Constant(kGroups, 100.0), kCurvature);
    }
    return ticks;
  };
  const int first = ticks_yielding();
  BOOST_TEST(first > 1);
  BOOST_TEST(ticks_yielding() == first);
}

BOOST_AUTO_TEST_CASE(nan_qp_is_refused_in_hard_and_elastic_mode) {
  ElasticSolver solver(kN, 0, elastic_rows(), 1e-6);
  const Eigen::VectorXd penalty = Eigen::VectorXd::Ones(kGroups);
  for (const int before : {0, 1}) {
    BOOST_TEST((solver.solve(problem_of(before), penalty, kCurvature).status == Status::kOk));
    QpProblem bad = problem_of(before);
    bad.g[2] = std::nan("");
    BOOST_TEST((solver.solve(bad, penalty, kCurvature).status == Status::kNonFinite));
  }
}

BOOST_AUTO_TEST_SUITE_END()
