// SPDX-License-Identifier: BSD-3-Clause
// Reach each fallback level by a failure of all levels above it.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "lambda_task.hpp"
#include "pushed_robot.hpp"
#include "safety/fallback_chain.hpp"
#include "safety/holding_torques.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "tick/controller_access.hpp"

using namespace surefoot;

namespace {

const double kNaN = std::nan("");

/// Effect of the user's task on the QP.
enum class TaskFault { kNothing, kNotANumber, kHeavy };

bool write_faulty_rows(TaskFault how, TaskRows& rows) {
  rows.A_a.setZero();
  rows.weight.setZero();
  rows.A_a(0, 1) = 1.0;
  rows.b[0] = how == TaskFault::kNotANumber ? kNaN : 0.0;
  // The weight and the request are so large that rounding alone exceeds the tolerance.
  if (how == TaskFault::kHeavy) {
    rows.weight[0] = 1e4;
    rows.b[0] = 3e6;
  }
  return true;
}

/// A standing robot whose QP fails when the test sets `task_fault`.
struct Standing {
  Robot robot = quadruped();
  ControllerOptions options;
  StandController controller;
  TaskFault task_fault = TaskFault::kNothing;
  std::uint32_t tick = 0;
  LowState report = resting_sample(robot, 0);
  LowCmd last;

  explicit Standing(double power_limit = ControllerOptions().power_limit)
      : options{0.0, 0.0, QpForm::kAuto, power_limit},
        controller(robot, robot.config().gains, options) {
    ControllerAccess::end_sensor_check(controller);
    controller.add_task(task(1, [this](const RobotState&, TaskRows& rows) {
      return write_faulty_rows(task_fault, rows);
    }));
    for (int i = 0; i < 10; ++i) step();
  }
  const LowCmd& step() {
    report.tick = tick;
    tick += 2;
    return last = controller.update(report);
  }
  Vector12 tau() const {
    Vector12 out;
    for (int i = 0; i < kMotors; ++i) out[i] = last.motorCmd[i].tau;
    return out;
  }
};

/// The fallback levels below the QP, and their inputs.
struct MovingRobot {
  Robot robot = quadruped();
  Gains gains;
  RobotState state = random_state(robot, 6, 0.3);
  Reference reference = reference_at(robot, state);
  Dynamics dynamics = dynamics_at(robot, state);
  FallbackChain chain{robot};
  FeetMatrix planned = FeetMatrix::Zero();

  MovingRobot() { planned.row(2) << 35.0, 25.0, 30.0, 28.0; }
  FallbackLevel compute_fallback() {
    return chain.compute_fallback(gains, dynamics, state, reference);
  }
  void remember_solution() { chain.remember(gains, dynamics, state, reference, planned); }
  Vector12 torques_of_forces(const FeetMatrix& forces) const {
    Vector12 tau;
    for (int leg = 0; leg < kLegs; ++leg) {
      const LegDynamics& L = dynamics.legs()[leg];
      tau.segment<3>(3 * leg) = L.h_leg - L.J_leg.transpose() * forces.col(leg);
    }
    return tau;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(fallback_chain)

BOOST_FIXTURE_TEST_CASE(qp_limited_by_rounding_is_solved_again_from_a_cold_start, Standing) {
  BOOST_TEST((controller.fallback_level() == FallbackLevel::kSolved));
  task_fault = TaskFault::kHeavy;
  for (int k = 0; k < 20; ++k) {  // without a time limit: a cold solve is a full solution
    step();
    BOOST_TEST(is_usable(controller.status()));
    BOOST_TEST((tau().cwiseAbs().array() <= robot.config().tau_max.array() * 1.00001).all());
  }
  // Rounding decides how often.
  BOOST_TEST(controller.fallback_count(FallbackLevel::kColdSolve) > 5U);
  BOOST_TEST((controller.fault() == Status::kOk));
}

BOOST_FIXTURE_TEST_CASE(failed_qp_is_replaced_by_forces_for_the_task_wrench, Standing) {
  const Vector12 solved = tau();
  task_fault = TaskFault::kNotANumber;
  for (int k = 0; k < 5; ++k) {
    step();
    BOOST_TEST((controller.fallback_level() == FallbackLevel::kForces));
    BOOST_TEST((controller.status() == Status::kBadTask));
    BOOST_TEST((tau() - solved).norm() < 0.2);
    BOOST_TEST(last.motorCmd[0].Kd == 0.0F);
  }
  task_fault = TaskFault::kNothing;
  step();
  BOOST_TEST((controller.fallback_level() == FallbackLevel::kSolved));
  BOOST_TEST((tau() - solved).norm() < 0.2);
  BOOST_TEST((controller.fault() == Status::kBadTask));
  BOOST_TEST(controller.fallback_count(FallbackLevel::kForces) == 5U);
}

BOOST_FIXTURE_TEST_CASE(solve_failures_over_10_ms_latch_motor_damping, Standing) {
  task_fault = TaskFault::kNotANumber;
  for (int k = 0; k < 5; ++k) BOOST_TEST(!motors_brake(step()));
  for (int k = 0; k < 5; ++k) {
    BOOST_TEST(motors_brake(step()));
    task_fault = TaskFault::kNothing;  // too late: damping is latched
    BOOST_TEST((controller.fallback_level() == FallbackLevel::kDamping));
    BOOST_TEST((controller.status() == Status::kDamping));
  }
  controller.reset();
  step();
  BOOST_TEST((controller.fallback_level() == FallbackLevel::kSolved));
}

// The fallback computes torques from the current sample; it does not repeat the last command.
BOOST_FIXTURE_TEST_CASE(fallback_torques_follow_the_current_sample, Standing) {
  task_fault = TaskFault::kNotANumber;
  report.imu.gyroscope = {0.2F, 0.0F, 0.0F};
  const LowCmd first = step();
  report.imu.gyroscope = {0.4F, 0.0F, 0.0F};
  step();
  BOOST_TEST((controller.fallback_level() == FallbackLevel::kForces));
  BOOST_TEST(std::abs(last.motorCmd[1].tau - first.motorCmd[1].tau) > 1e-3);
}

BOOST_FIXTURE_TEST_CASE(bad_samples_and_failed_solves_share_one_10_ms_hold, Standing) {
  const FallbackLevel expected[] = {FallbackLevel::kForces, FallbackLevel::kHold,
                                    FallbackLevel::kForces, FallbackLevel::kHold,
                                    FallbackLevel::kHold};
  for (const FallbackLevel fallback_level : expected) {
    const LowCmd before = last;
    task_fault =
        fallback_level == FallbackLevel::kForces ? TaskFault::kNotANumber : TaskFault::kNothing;
    report.imu.gyroscope[0] = fallback_level == FallbackLevel::kHold ? std::nanf("") : 0.0F;
    step();
    BOOST_TEST((controller.fallback_level() == fallback_level));
    // The held command is the last one sent, not the last one that was solved.
    if (fallback_level == FallbackLevel::kHold)
      BOOST_TEST(last.motorCmd[2].tau == before.motorCmd[2].tau);
  }
  BOOST_TEST(motors_brake(step()));
}

BOOST_FIXTURE_TEST_CASE(failed_first_solve_damps_without_latching, Standing) {
  controller.reset();
  task_fault = TaskFault::kNotANumber;
  for (int k = 0; k < 10; ++k) {
    BOOST_TEST(motors_brake(step()));
    BOOST_TEST((controller.fallback_level() == FallbackLevel::kDamping));
    BOOST_TEST((controller.status() == Status::kBadTask));
  }
  task_fault = TaskFault::kNothing;
  step();
  BOOST_TEST((controller.fallback_level() == FallbackLevel::kSolved));
}

// The body pitches and the front knees turn; the holding torques take less power than the fallback.
BOOST_AUTO_TEST_CASE(fallback_torques_respect_the_power_limit) {
  const auto run_fallback = [](Standing& s) {
    s.report.imu.gyroscope = {0.0F, 0.8F, 0.0F};
    for (const int i : {2, 5}) s.report.motorState[i].dq = 2.0F;
    // With constant joint speeds no leg counts as runaway.
    for (int k = 0; k < 10; ++k) s.step();
    s.task_fault = TaskFault::kNotANumber;
    s.step();
    BOOST_REQUIRE((s.controller.fallback_level() == FallbackLevel::kForces));
  };
  Standing free;
  run_fallback(free);
  const double unlimited = free.controller.command_power();
  Standing limited(0.97 * unlimited);
  run_fallback(limited);
  BOOST_TEST(limited.controller.command_power() <= 0.97 * unlimited * 1.0001);
  BOOST_TEST(limited.controller.power_scale() < 1.0);
}

BOOST_FIXTURE_TEST_CASE(fallback_forces_produce_the_task_wrench, MovingRobot) {
  reference.a_com = Vector3(0.5, -0.4, 0.3);
  BOOST_TEST((compute_fallback() == FallbackLevel::kForces));
  BOOST_TEST(chain.damping() == 0.0);
  // The QP solves the same tasks, with the inertia of the legs.
  WholeBodyController controller(robot, gains);
  const Solution& solution = controller.solve(dynamics, state, reference);
  BOOST_REQUIRE(is_usable(solution.status));
  for (int i = 0; i < kMotors; ++i) {
    const double tau = solution.torques[robot.motor_to_v()[i] - 6];
    BOOST_TEST(std::abs(chain.torques()[i] - tau) < 0.05 * robot.config().tau_max[i]);
  }
}

// At its limits the QP gives less than the tasks request. The fallback starts from these forces.
BOOST_FIXTURE_TEST_CASE(fallback_forces_start_from_the_last_solved_forces, MovingRobot) {
  remember_solution();
  BOOST_TEST((compute_fallback() == FallbackLevel::kForces));
  BOOST_TEST((chain.torques() - torques_of_forces(planned)).norm() < 1e-9);
  const Vector12 before = chain.torques();
  reference.a_com.z() += 1.0;
  BOOST_TEST((compute_fallback() == FallbackLevel::kForces));
  // The desired acceleration rises by 1 m/s^2 upwards; only the force for this is added.
  FeetMatrix more;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Matrix3 J = dynamics.legs()[leg].J_leg;
    const Vector3 change = chain.torques().segment<3>(3 * leg) - before.segment<3>(3 * leg);
    more.col(leg) = -J.transpose().fullPivLu().solve(change);
  }
  BOOST_TEST((more.rowwise().sum() - robot.mass() * Vector3::UnitZ()).norm() < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(fallback_forces_stay_in_friction_cones_and_share_the_load, MovingRobot) {
  const double weight = robot.mass() * kGravity;
  const auto missed = [&](const FeetMatrix& forces, const Vector3& wanted) {
    return (forces.rowwise().sum() - wanted).norm();
  };
  const Eigen::Vector4d all = Eigen::Vector4d::Ones(), mu = Eigen::Vector4d::Constant(0.5);
  const Vector3 up(0.0, 0.0, weight), n = Vector3::UnitZ();
  const auto share = [&](const Vector3& force, const Eigen::Vector4d& most) {
    return add_wrench(dynamics, FeetMatrix::Zero(), {force, Vector3::Zero()}, all, {n, mu, most});
  };
  BOOST_TEST(missed(share(up, 3.0 * weight * all), up) < 1e-6 * weight);
  // One foot may carry next to nothing: the others carry nearly all of its load.
  Eigen::Vector4d most = 3.0 * weight * all;
  most[FL_] = 0.02 * weight;
  BOOST_TEST(share(up, most)(2, FL_) <= most[FL_] * 1.0001);
  BOOST_TEST(missed(share(up, most), up) < 0.1 * weight);
  // A force beyond the friction limit: friction is used up, and the weight is still carried.
  const Vector3 pulled(weight, 0.0, weight);
  const FeetMatrix held = share(pulled, 3.0 * weight * all);
  for (int leg = 0; leg < kLegs; ++leg) {
    BOOST_TEST(held.col(leg).head<2>().norm() <= 0.5 * held(2, leg) * 1.0001);
    BOOST_TEST(held(2, leg) >= 0.0);
  }
  BOOST_TEST(held.row(2).sum() > 0.9 * weight);
}

BOOST_FIXTURE_TEST_CASE(nan_reference_falls_back_to_the_last_forces, MovingRobot) {
  remember_solution();
  reference.p_com.x() = kNaN;
  BOOST_TEST((compute_fallback() == FallbackLevel::kLastForces));
  BOOST_TEST((chain.torques() - torques_of_forces(planned)).norm() < 1e-9);
  BOOST_TEST(chain.damping() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(missing_forces_fall_back_to_gravity_torques_with_damping, MovingRobot) {
  const RobotState nothing(robot.nq(), robot.nv());
  const Vector12 hold = holding_torques(dynamics, robot.mass(), nothing, Eigen::Vector4d::Ones());
  const auto holds = [&] {
    BOOST_TEST((compute_fallback() == FallbackLevel::kGravity));
    BOOST_TEST((chain.torques() - hold).norm() < 1e-9);
    BOOST_TEST(chain.damping() == gains.damping_kd);
  };
  reference.p_com.x() = kNaN;
  holds();
  planned(1, RR_) = kNaN;  // or the planned forces are not finite
  remember_solution();
  holds();
  planned(1, RR_) = 0.0;  // or the planned forces were forgotten by reset()
  remember_solution();
  chain.reset();
  holds();
}

// On all four feet the legs in the air would be thrown against the ground.
BOOST_FIXTURE_TEST_CASE(gravity_torques_of_a_stepping_robot_load_the_stance_feet, MovingRobot) {
  reference.stepping = true;
  for (const int leg : {FL_, RR_}) {
    reference.feet[leg].stance = false;
    reference.feet[leg].load = 0.0;
  }
  reference.p_com.x() = kNaN;
  BOOST_REQUIRE((compute_fallback() == FallbackLevel::kGravity));
  double carried = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const Vector3 at_foot = L.h_leg - chain.torques().segment<3>(3 * leg);
    const Vector3 force = L.J_leg.transpose().fullPivLu().solve(at_foot);
    if (leg == FL_ || leg == RR_) BOOST_TEST(force.norm() < 1e-9);
    carried += force.z();
  }
  BOOST_TEST(carried == robot.mass() * kGravity, boost::test_tools::tolerance(0.01));
}

BOOST_FIXTURE_TEST_CASE(nan_state_falls_back_to_holding_the_last_torques, MovingRobot) {
  const Vector12 before = (compute_fallback(), chain.torques());
  state.q[8] = kNaN;
  dynamics.update(state.q, state.v, reference.ground_normal);
  BOOST_TEST((compute_fallback() == FallbackLevel::kHold));
  BOOST_TEST(chain.torques() == before);
}

BOOST_FIXTURE_TEST_CASE(fallback_torques_are_clipped_to_the_motor_torque_share, MovingRobot) {
  reference.a_com.z() = 200.0;
  gains.force_max_contact = 100.0;
  BOOST_REQUIRE((compute_fallback() == FallbackLevel::kForces));
  const Vector12& most = robot.config().tau_max;
  BOOST_TEST((chain.torques().cwiseAbs() - most).maxCoeff() <= 0.0);
  BOOST_TEST((chain.torques().cwiseAbs() - most).maxCoeff() > -1e-6);
  chain.set_torque_share(Vector12::Constant(0.4));
  compute_fallback();
  BOOST_TEST((chain.torques().cwiseAbs() - 0.4 * most).maxCoeff() < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
