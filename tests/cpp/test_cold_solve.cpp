// SPDX-License-Identifier: BSD-3-Clause
// A failed QP is solved again from a cold start.
#include <boost/test/unit_test.hpp>

#include "lambda_task.hpp"
#include "pushed_robot.hpp"
#include "random_qp.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "wbc/qp_solver.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(cold_solve)

// Huge multipliers as warm start: ProxQP does not converge within its iterations.
BOOST_AUTO_TEST_CASE(cold_start_solves_a_qp_that_failed_from_a_bad_warm_start) {
  int unsolved = 0, recovered = 0;
  for (int seed = 0; seed < 20; ++seed) {
    const RandomQp random(seed);
    QpSolver solver(12, 0, 72, 1e-6, 0);
    solver.warm_start_from(Eigen::VectorXd::Constant(72, 1e9));
    if (solver.solve(random.problem).status == Status::kOk) continue;
    ++unsolved;
    solver.reset();
    solver.set_tolerance(1e-5);
    if (solver.solve(random.problem, 1).status != Status::kOk) continue;
    ++recovered;
    BOOST_TEST(kkt_residual(random.problem, solver.x(), solver.y(), solver.z()) < 1e-3);
  }
  BOOST_TEST(unsolved > 0);
  BOOST_TEST(recovered > unsolved / 2);
}

// A task with so much weight and such a large request that rounding alone exceeds the tolerance.
BOOST_AUTO_TEST_CASE(cold_solve_accepts_residuals_up_to_10_times_the_tolerance) {
  const Robot robot = quadruped();
  const RobotState state = standing_state(robot);
  const Reference reference = reference_at(robot, state);
  const Dynamics dynamics = dynamics_at(robot, state);
  double requested_acceleration = 0.0;
  WholeBodyController controller(robot);
  controller.add_task(task(1, [&](const RobotState&, TaskRows& rows) {
    rows.A_a(0, 1) = 1.0;
    rows.b[0] = requested_acceleration;
    rows.weight[0] = 1e4;
    return true;
  }));
  int failed = 0, accepted = 0, unsolved = 0;
  for (requested_acceleration = 1e6; requested_acceleration < 1e9; requested_acceleration *= 1.05) {
    const Solution& solution = controller.solve(dynamics, state, reference);
    if (is_usable(solution.status)) continue;
    ++failed;
    controller.solve_cold(dynamics);
    (is_usable(solution.status) ? accepted : unsolved) += 1;
    if (!is_usable(solution.status)) continue;
    BOOST_TEST(std::max(solution.primal_residual, solution.dual_residual) <= 5.0 * 10.0 * 1e-6);
    for (int i = 0; i < kMotors; ++i) {
      const double tau = solution.torques[robot.motor_to_v()[i] - 6];
      BOOST_TEST(std::abs(tau) <= robot.config().tau_max[i]);
    }
  }
  BOOST_TEST(failed > 10);
  BOOST_TEST(accepted > 5);
  BOOST_TEST(unsolved > 5);  // residuals beyond 10 times the tolerance are refused
}

BOOST_AUTO_TEST_CASE(cold_solve_skips_solved_qps_and_failed_tasks) {
  const Robot robot = quadruped();
  const RobotState state = random_state(robot, 6, 0.3);
  const Reference reference = reference_at(robot, state);
  const Dynamics dynamics = dynamics_at(robot, state);
  WholeBodyController controller(robot);
  const Solution good = controller.solve(dynamics, state, reference);
  BOOST_TEST((controller.solve_cold(dynamics).status == good.status));
  BOOST_TEST(controller.solution().iterations == good.iterations);
  int task_calls = 0;
  controller.add_task(task(1, [&](const RobotState&, TaskRows&) { return ++task_calls, false; }));
  controller.solve(dynamics, state, reference);
  BOOST_TEST((controller.solve_cold(dynamics).status == Status::kBadTask));
  BOOST_TEST(task_calls == 1);
}

BOOST_AUTO_TEST_SUITE_END()
