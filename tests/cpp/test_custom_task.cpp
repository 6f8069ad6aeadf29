// SPDX-License-Identifier: BSD-3-Clause
// Tasks of the user, through the public interface.
#include <boost/test/unit_test.hpp>

#include "lambda_task.hpp"
#include "pushed_robot.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/whole_body_controller.hpp"

using namespace surefoot;

namespace {

constexpr double kScale = 30.0;  // brings rows to order one, like the rows of the QP

// Write heavy rows on the base's angular acceleration, a joint's acceleration and a force.
bool write_mixed_rows(const RobotState&, TaskRows& rows) {
  rows.A_a(0, 4) = 1.0 / kScale;
  rows.A_a(1, 8) = 1.0 / kScale;
  rows.A_f(2, 3 * FL_ + 2) = 1.0 / kScale;
  rows.b << 2.0 / kScale, -5.0 / kScale, 35.0 / kScale;
  rows.weight << 300.0, 300.0, 300.0;
  return true;
}

// Return low gains, so that a heavy task dominates.
Gains low_weight_gains() {
  Gains g;
  g.weight_com_horizontal = g.weight_com_vertical = 0.1;
  g.weight_base_tilt = g.weight_base_yaw = 0.01;
  g.weight_force = 0.02;
  return g;
}

struct MovingRobot {
  Robot robot = quadruped();
  RobotState state = random_state(robot, 6, 0.5);
  Reference reference = reference_at(robot, state);
};

}  // namespace

BOOST_AUTO_TEST_SUITE(custom_task)

BOOST_FIXTURE_TEST_CASE(heavy_task_reaches_its_target_in_both_forms, MovingRobot) {
  WholeBodyController condensed(robot, low_weight_gains(), {QpForm::kCondensed, 1e-12});
  WholeBodyController general(robot, low_weight_gains(), {QpForm::kGeneral, 1e-12});
  const Solution without = condensed.update(state, reference);
  condensed.add_task(task(3, write_mixed_rows));
  general.add_task(task(3, write_mixed_rows));
  const Solution& a = condensed.update(state, reference);
  const Solution& b = general.update(state, reference);
  BOOST_REQUIRE((a.status == Status::kOk && b.status == Status::kOk));
  BOOST_TEST((a.torques - b.torques).norm() < 1e-6);
  BOOST_TEST(std::abs(a.accelerations[4] - 2.0) < 0.2);
  BOOST_TEST(std::abs(a.accelerations[8] + 5.0) < 0.2);
  BOOST_TEST(std::abs(a.forces(2, FL_) - 35.0) < 1.0);
  BOOST_TEST((a.torques - without.torques).norm() > 0.1);
}

// The accelerations of a task refer to the state it receives, also with shifted dynamics.
BOOST_FIXTURE_TEST_CASE(shifted_dynamics_give_the_same_task_acceleration, MovingRobot) {
  const auto lift = task(1, [](const RobotState&, TaskRows& rows) {
    rows.A_a(0, 2) = 1.0;
    rows.b[0] = 0.7;
    rows.weight[0] = 100.0;
    return true;
  });
  RobotState resting = state;
  resting.q.head<3>().setZero();
  resting.v.head<3>().setZero();
  Dynamics shifted = dynamics_at(robot, resting);
  shifted.shift(state.q.head<3>(), dynamics_at(robot, state).v_world_base());
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    WholeBodyController direct(robot, Gains(), {form, 1e-10}), moved(robot, Gains(), {form, 1e-10});
    direct.add_task(lift);
    moved.add_task(lift);
    const Solution& a = direct.update(state, reference);
    const Solution& b = moved.solve(shifted, state, reference);
    BOOST_REQUIRE((a.status == Status::kOk && b.status == Status::kOk));
    BOOST_TEST((a.torques - b.torques).norm() < 1e-6);
    BOOST_TEST(std::abs(b.accelerations[2] - 0.7) < 0.1);
  }
}

BOOST_FIXTURE_TEST_CASE(zero_weight_task_does_not_change_the_torques, MovingRobot) {
  WholeBodyController with(robot), without(robot);
  with.add_task(task(1, [](const RobotState&, TaskRows& rows) {
    rows.A_a.setOnes();
    rows.b[0] = 1e3;
    rows.weight.setZero();
    return true;
  }));
  const Eigen::VectorXd expected = without.update(state, reference).torques;
  BOOST_TEST((with.update(state, reference).torques - expected).norm() < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(failing_or_nan_task_returns_bad_task_and_keeps_the_last_torques,
                        MovingRobot) {
  const double nan = std::nan("");
  const LambdaTask::Write bad[] = {
      [](const RobotState&, TaskRows&) { return false; },
      [&](const RobotState&, TaskRows& rows) { return rows.b[0] = nan, true; },
      [&](const RobotState&, TaskRows& rows) { return rows.A_a(0, 3) = nan, true; },
      [&](const RobotState&, TaskRows& rows) { return rows.A_f(0, 3) = 1.0 / 0.0, true; },
      [&](const RobotState&, TaskRows& rows) { return rows.weight[0] = -1.0, true; },
      [&](const RobotState&, TaskRows& rows) { return rows.b.resize(2), true; }};
  for (const LambdaTask::Write& write : bad) {
    for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
      WholeBodyController controller(robot, Gains(), {form});
      const Eigen::VectorXd good = controller.update(state, reference).torques;
      controller.add_task(task(1, write));
      BOOST_TEST((controller.update(state, reference).status == Status::kBadTask));
      BOOST_TEST((controller.solution().torques == good));
    }
  }
}

BOOST_AUTO_TEST_CASE(stand_controller_damps_while_its_task_keeps_failing) {
  const Robot robot = quadruped();
  StandController controller(robot);
  bool works = true;
  controller.add_task(task(1, [&](const RobotState&, TaskRows&) { return works; }));
  for (std::uint32_t tick = 0; tick < 20; tick += 2) {
    controller.update(resting_sample(robot, tick));
    BOOST_TEST((controller.status() == Status::kOk));
  }
  works = false;
  controller.update(resting_sample(robot, 20));
  BOOST_TEST((controller.status() == Status::kBadTask));
  for (std::uint32_t tick = 22; tick < 40; tick += 2)
    controller.update(resting_sample(robot, tick));
  BOOST_TEST((controller.status() == Status::kDamping));
  BOOST_TEST((controller.fault() == Status::kBadTask));
}

BOOST_FIXTURE_TEST_CASE(null_task_or_task_without_rows_is_refused, MovingRobot) {
  WholeBodyController controller(robot);
  BOOST_CHECK_THROW(controller.add_task(nullptr), Error);
  BOOST_CHECK_THROW(controller.add_task(task(0, write_mixed_rows)), Error);
}

BOOST_AUTO_TEST_SUITE_END()
