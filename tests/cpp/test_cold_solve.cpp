// SPDX-License-Identifier: BSD-3-Clause
// A program that was not solved, once more from nothing.
#include <boost/test/unit_test.hpp>

#include "kkt.hpp"
#include "lambda_task.hpp"
#include "motion.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "wbc/qp_solver.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(cold_solve)

// Multipliers without end send ProxQP so far away that it does not come back in its time.
BOOST_AUTO_TEST_CASE(a_solver_lost_by_its_warm_start_finds_the_answer_from_nothing) {
  int lost = 0;
  for (int seed = 0; seed < 20; ++seed) {
    const RandomProgram random(seed);
    QpSolver solver(12, 0, 72, 1e-6, 0);
    solver.start_from(Eigen::VectorXd::Constant(72, 1e9));
    if (solver.solve(random.problem).status == Status::kOk) continue;
    ++lost;
    solver.reset();
    BOOST_TEST((solver.solve(random.problem).status == Status::kOk));
    BOOST_TEST(kkt_residual(random.problem, solver.x(), solver.y(), solver.z()) < 1e-4);
  }
  BOOST_TEST(lost > 0);
}

// No answer is as exact as that; ten times as rough some are.
BOOST_AUTO_TEST_CASE(a_cold_solve_is_checked_against_ten_times_the_tolerance) {
  const Robot robot = quadruped();
  int failed = 0, saved = 0;
  for (int seed = 0; seed < 60; ++seed) {
    const RobotState state = random_state(robot, seed, 0.3);
    const Reference reference = reference_at(robot, state);
    const Dynamics dynamics = dynamics_at(robot, state);
    WholeBodyController usual(robot), strict(robot, Gains(), {Form::kAuto, 1e-14});
    const Solution& first = strict.solve(dynamics, state, reference);
    if (is_usable(first.status)) continue;
    ++failed;
    BOOST_TEST((first.status == Status::kMaxIterations));
    const Solution& again = strict.solve_cold(dynamics);
    if (!is_usable(again.status)) continue;
    ++saved;
    BOOST_TEST(std::max(again.primal_residual, again.dual_residual) <= 5.0 * 10.0 * 1e-14);
    const Solution& expected = usual.solve(dynamics, state, reference);
    BOOST_TEST((again.torques - expected.torques).norm() < 1e-3);
  }
  BOOST_TEST(failed > 0);
  BOOST_TEST(saved > 0);
}

BOOST_AUTO_TEST_CASE(what_was_solved_or_cannot_be_is_not_solved_again) {
  const Robot robot = quadruped();
  const RobotState state = random_state(robot, 6, 0.3);
  const Reference reference = reference_at(robot, state);
  const Dynamics dynamics = dynamics_at(robot, state);
  WholeBodyController controller(robot);
  const Solution good = controller.solve(dynamics, state, reference);
  BOOST_TEST((controller.solve_cold(dynamics).status == good.status));
  BOOST_TEST(controller.solution().iterations == good.iterations);
  int asked = 0;
  controller.add_task(task(1, [&](const RobotState&, TaskRows&) { return ++asked, false; }));
  controller.solve(dynamics, state, reference);
  BOOST_TEST((controller.solve_cold(dynamics).status == Status::kBadTask));
  BOOST_TEST(asked == 1);
}

BOOST_AUTO_TEST_SUITE_END()
