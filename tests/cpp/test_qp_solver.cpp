// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "kkt.hpp"
#include "wbc/qp_solver.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(qp_solver)

BOOST_AUTO_TEST_CASE(every_accepted_answer_satisfies_kkt_warm_or_cold) {
  QpSolver solver(12, 0, 72, 1e-6);
  for (int seed = 0; seed < 300; ++seed) {
    const RandomProgram random(seed);
    const QpResult result = solver.solve(random.problem);
    BOOST_TEST((result.status == Status::kOk));
    BOOST_TEST(kkt_residual(random.problem, solver.x(), solver.y(), solver.z()) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(equalities_hold_and_their_multipliers_are_right) {
  QpSolver solver(30, 18, 88, 1e-6);
  for (int seed = 0; seed < 100; ++seed) {
    const RandomProgram random(seed, 30, 18, 88);
    BOOST_TEST((solver.solve(random.problem).status == Status::kOk));
    BOOST_TEST(kkt_residual(random.problem, solver.x(), solver.y(), solver.z()) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_tight_tolerance_is_met) {
  QpSolver solver(12, 0, 72, 1e-12);
  for (int seed = 0; seed < 100; ++seed) {
    const RandomProgram random(seed);
    BOOST_TEST((solver.solve(random.problem).status == Status::kOk));
    BOOST_TEST(kkt_residual(random.problem, solver.x(), solver.y(), solver.z()) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE(what_the_result_says_of_itself_is_so) {
  QpSolver solver(12, 0, 72, 1e-6);
  for (int seed = 0; seed < 50; ++seed) {
    const RandomProgram random(seed);
    const QpProblem& p = random.problem;
    const QpResult result = solver.solve(p);
    const Eigen::VectorXd Cx = p.C * solver.x();
    const double violation = std::max({0.0, (p.l - Cx).maxCoeff(), (Cx - p.u).maxCoeff()});
    const Eigen::VectorXd gradient = p.H * solver.x() + p.g + p.C.transpose() * solver.z();
    BOOST_TEST(std::abs(result.primal_residual - violation) < 1e-12);
    BOOST_TEST(std::abs(result.dual_residual - gradient.cwiseAbs().maxCoeff()) < 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(a_program_that_is_not_finite_is_refused_and_the_next_is_solved) {
  QpSolver solver(12, 0, 72, 1e-6);
  for (int field = 0; field < 5; ++field) {
    RandomProgram random(field);
    Eigen::VectorXd* vectors[] = {&random.problem.g, &random.problem.l, &random.problem.u};
    if (field < 3) (*vectors[field])[3] = std::nan("");
    if (field == 3) random.problem.H(1, 2) = std::nan("");
    if (field == 4) random.problem.C(1, 2) = std::numeric_limits<double>::infinity();
    BOOST_TEST((solver.solve(random.problem).status == Status::kNonFinite));
    BOOST_TEST((solver.solve(RandomProgram(field).problem).status == Status::kOk));
  }
}

BOOST_AUTO_TEST_CASE(contradictory_rows_are_not_called_solved) {
  QpSolver solver(12, 0, 72, 1e-6);
  RandomProgram random(3);
  random.problem.C.row(70) = random.problem.C.row(71);
  random.problem.l[70] = random.problem.u[71] + 1.0;
  random.problem.u[70] = random.problem.l[70] + 1.0;
  BOOST_TEST((solver.solve(random.problem).status != Status::kOk));
  BOOST_TEST((solver.solve(RandomProgram(3).problem).status == Status::kOk));
}

BOOST_AUTO_TEST_SUITE_END()
