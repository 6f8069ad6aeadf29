// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "kkt.hpp"
#include "wbc/active_set_steps.hpp"
#include "wbc/qp_solver.hpp"

using namespace surefoot;

namespace {

double kkt(const QpProblem& problem, const ActiveSetSteps& steps) {
  return kkt_residual(problem, steps.x(), steps.y(), steps.z());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(active_set_steps)

BOOST_AUTO_TEST_CASE(from_the_right_rows_one_step_is_the_answer_to_rounding) {
  for (const int n_eq : {0, 6}) {
    QpSolver solver(12, n_eq, 72, 1e-10);
    ActiveSetSteps steps(12, n_eq, 72);
    for (int seed = 0; seed < 100; ++seed) {
      const QpProblem problem = RandomProgram(seed, 12, n_eq, 72).problem;
      BOOST_TEST((solver.solve(problem).status == Status::kOk));
      const Eigen::VectorXd z = (solver.z().array().abs() < 1e-6).select(0.0, solver.z());
      BOOST_TEST(steps.start(problem, z));
      BOOST_TEST(steps.step(problem));
      BOOST_TEST(kkt(problem, steps) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(where_no_row_is_left_to_enter_the_program_is_solved) {
  ActiveSetSteps steps(12, 4, 72);
  int ended = 0;
  for (int seed = 0; seed < 300; ++seed) {
    const QpProblem problem = RandomProgram(seed, 12, 4, 72).problem;
    BOOST_TEST(steps.start(problem, Eigen::VectorXd::Zero(72)));
    for (int count = 0; count < 60 && steps.step(problem); ++count) {
      if (steps.enter(problem, problem.C * steps.x(), 1e-12)) continue;
      BOOST_TEST(kkt(problem, steps) < 1e-10);
      ++ended;
      break;
    }
  }
  BOOST_TEST(ended > 290);  // no promise, but worth the try
}

BOOST_AUTO_TEST_CASE(rows_that_follow_from_others_are_left_out) {
  QpProblem problem = RandomProgram(1).problem;
  ActiveSetSteps steps(12, 0, 72);
  problem.C.row(41) = 2.0 * problem.C.row(40);
  problem.C.row(42) = problem.C.row(40) - problem.C.row(43);
  problem.C.row(44).setZero();
  for (int row = 40; row < 45; ++row) problem.l[row] = problem.u[row] = 0.0;
  Eigen::VectorXd z = Eigen::VectorXd::Zero(72);
  z.segment(40, 5).setOnes();
  BOOST_TEST(steps.start(problem, z));
  BOOST_TEST(steps.step(problem));
  const Eigen::VectorXd Cx = problem.C * steps.x();
  BOOST_TEST(Cx.segment(40, 5).cwiseAbs().maxCoeff() < 1e-12);
  BOOST_TEST((steps.z().array() != 0.0).count() == 2);
  const Eigen::VectorXd gradient =
      problem.H * steps.x() + problem.g + problem.C.transpose() * steps.z();
  BOOST_TEST(gradient.cwiseAbs().maxCoeff() < 1e-12);
}

BOOST_AUTO_TEST_CASE(programs_that_are_not_for_it_are_refused) {
  ActiveSetSteps steps(12, 4, 72);
  const Eigen::VectorXd z = Eigen::VectorXd::Zero(72);
  QpProblem flat = RandomProgram(2, 12, 4, 72).problem;
  flat.H.setZero();
  BOOST_TEST(!steps.start(flat, z));
  QpProblem dependent = RandomProgram(2, 12, 4, 72).problem;
  dependent.A.row(3).setZero();
  BOOST_TEST(!steps.start(dependent, z));
}

BOOST_AUTO_TEST_SUITE_END()
