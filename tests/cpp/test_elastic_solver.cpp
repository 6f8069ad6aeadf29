// SPDX-License-Identifier: BSD-3-Clause
// Against the elastic program written out whole from its definition, and solved to a certificate.
#include "elastic.hpp"

using namespace elastic;

namespace {

double violation(const QpProblem& p, const Eigen::VectorXd& x, int row) {
  const double value = p.C.row(row).dot(x);
  return std::max({0.0, value - p.u[row], p.l[row] - value});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(elastic_solver)

BOOST_AUTO_TEST_CASE(its_answer_is_the_whole_elastic_programs_feasible_or_not) {
  const ElasticRows rows = elastic_rows();
  const Eigen::VectorXd price = Eigen::VectorXd::LinSpaced(kGroups, 1.0, 10.0);
  for (const int n_eq : {0, 4}) {
    ElasticSolver solver(kN, n_eq, rows, 1e-6);
    int yielding = 0, firm = 0;
    for (int seed = 0; seed < 200; ++seed) {
      const QpProblem p = program(seed, n_eq);
      BOOST_REQUIRE((solver.solve(p, price, kCurvature).status == Status::kOk));
      const Eigen::VectorXd best = certified(whole(p, rows, price));
      BOOST_TEST((solver.x() - best.head(kN)).norm() < 1e-3);
      BOOST_TEST((solver.slack() - best.tail(kGroups)).norm() < 1e-3);
      (best.tail(kGroups).maxCoeff() > 1e-4 ? yielding : firm) += 1;
      if (seed % 10 == 0) solver.reset();
    }
    BOOST_TEST(yielding >= 100);
    BOOST_TEST(firm >= 20);
  }
}

BOOST_AUTO_TEST_CASE(at_a_tight_tolerance_the_answers_agree_to_six_digits) {
  const ElasticRows rows = elastic_rows();
  const Eigen::VectorXd price = Eigen::VectorXd::Constant(kGroups, 1.0);
  ElasticSolver solver(kN, 0, rows, 1e-9);
  for (int seed = 0; seed < 100; ++seed) {
    const QpProblem p = program(seed);
    BOOST_REQUIRE((solver.solve(p, price, kCurvature).status == Status::kOk));
    const Eigen::VectorXd best = certified(whole(p, rows, price));
    BOOST_TEST((solver.x() - best.head(kN)).norm() < 1e-6);
    BOOST_TEST((solver.slack() - best.tail(kGroups)).norm() < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(a_groups_slack_is_its_worst_rows_and_hard_rows_never_give_way) {
  const ElasticRows rows = elastic_rows();
  ElasticSolver solver(kN, 0, rows, 1e-10);
  for (int seed = 1; seed < 100; seed += 2) {
    const QpProblem p = program(seed);
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

// A price above the sum of a group's multipliers buys the hard answer exactly; below, the rows
// give.
BOOST_AUTO_TEST_CASE(the_penalty_is_exact_from_the_multipliers_sum_on) {
  const ElasticRows rows = elastic_rows();
  int tried = 0;
  for (int seed = 0; seed < 60; seed += 2) {
    const QpProblem p = program(seed);
    QpSolver hard(kN, 0, kRows, 1e-10);
    BOOST_REQUIRE((hard.solve(p).status == Status::kOk));
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(kGroups);
    for (int row = kHard; row < kRows; ++row) sum[rows.group[row]] += std::abs(hard.z()[row]);
    int group = 0;
    if (sum.maxCoeff(&group) < 0.1) continue;
    ++tried;
    Eigen::VectorXd price = 1.01 * sum.array() + 0.01;
    ElasticSolver dear(kN, 0, rows, 1e-10), cheap(kN, 0, rows, 1e-10);
    BOOST_REQUIRE((dear.solve(p, price, kCurvature).status == Status::kOk));
    BOOST_TEST((dear.x() - hard.x()).norm() < 1e-7);
    BOOST_TEST(dear.slack().maxCoeff() < 1e-8);
    BOOST_TEST(!dear.yielding());
    price[group] = 0.9 * sum[group];
    BOOST_REQUIRE((cheap.solve(p, price, kCurvature).status == Status::kOk));
    BOOST_TEST(cheap.slack()[group] > 1e-4);
    BOOST_TEST(cheap.yielding());
  }
  BOOST_TEST(tried >= 20);
}

BOOST_AUTO_TEST_CASE(it_returns_to_the_hard_program_when_nothing_gives_any_more) {
  ElasticSolver solver(kN, 0, elastic_rows(), 1e-6);
  const Eigen::VectorXd price = Eigen::VectorXd::Constant(kGroups, 100.0);
  solver.solve(program(1), price, kCurvature);
  BOOST_TEST(solver.yielding());
  for (int k = 0; k < 30; ++k) solver.solve(program(0), price, kCurvature);
  BOOST_TEST(!solver.yielding());
  BOOST_TEST(solver.slack().maxCoeff() == 0.0);
}

BOOST_AUTO_TEST_CASE(it_yields_for_as_long_the_second_time) {
  ElasticSolver solver(kN, 0, elastic_rows(), 1e-6);
  const auto ticks_yielding = [&] {
    const Eigen::VectorXd low = Eigen::VectorXd::Constant(kGroups, 1e-9);
    solver.solve(program(1), low, kCurvature);
    int ticks = 0;
    for (; solver.yielding() && ticks < 100; ++ticks) {
      solver.solve(program(0), Eigen::VectorXd::Constant(kGroups, 100.0), kCurvature);
    }
    return ticks;
  };
  const int first = ticks_yielding();
  BOOST_TEST(first > 1);
  BOOST_TEST(ticks_yielding() == first);
}

BOOST_AUTO_TEST_CASE(a_program_that_is_not_finite_is_refused_in_either_state) {
  ElasticSolver solver(kN, 0, elastic_rows(), 1e-6);
  const Eigen::VectorXd price = Eigen::VectorXd::Ones(kGroups);
  for (const int before : {0, 1}) {
    BOOST_TEST((solver.solve(program(before), price, kCurvature).status == Status::kOk));
    QpProblem bad = program(before);
    bad.g[2] = std::nan("");
    BOOST_TEST((solver.solve(bad, price, kCurvature).status == Status::kNonFinite));
  }
}

BOOST_AUTO_TEST_SUITE_END()
