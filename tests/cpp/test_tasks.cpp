// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include "quadruped.hpp"
#include "tasks/base_orientation_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/foot_task.hpp"
#include "tasks/force_task.hpp"

using namespace surefoot;

namespace {

constexpr double kStep = 1e-6;

// A robot, forces on its feet, and the motion they make: what the tasks' rows claim to know.
struct Pushed {
  Robot robot = quadruped();
  RobotState state = random_state(robot, 5, 0.5);
  Dynamics now{robot};
  Condensed condensed;
  Vector12 f;
  Eigen::VectorXd a;
  Pushed() : a(robot.nv()) {
    now.update(state.q, state.v, Vector3::UnitZ());
    BOOST_REQUIRE(condense(now, FeetMatrix::Zero(), 1e-6, condensed));
    std::srand(4);
    f = 30.0 * Vector12::Random();
    a.head<6>() = condensed.B * f + condensed.c;
    const Vector12 legs = condensed.leg_accelerations(a.head<6>());
    for (int i = 0; i < kMotors; ++i) a[robot.motor_to_v()[i]] = legs[i];
  }
  Dynamics after(double dt) const {
    Dynamics d(robot);
    const Eigen::VectorXd step = dt * state.v + 0.5 * dt * dt * a;
    d.update(integrate(robot, state.q, step), state.v + dt * a, Vector3::UnitZ());
    return d;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(tasks)

BOOST_FIXTURE_TEST_CASE(centre_of_mass_rows_give_the_acceleration_that_happens, Pushed) {
  const TaskRows rows = com_task(Gains(), Vector3::Zero(), robot.mass());
  const Vector3 happens =
      (after(kStep).v_world_com() - after(-kStep).v_world_com()) / (2.0 * kStep);
  BOOST_TEST((rows.A * f - rows.b - happens).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(orientation_rows_give_the_angular_acceleration_that_happens, Pushed) {
  const TaskRows rows = base_orientation_task(Gains(), Vector3::Zero(), now, condensed);
  const Vector3 happens =
      (after(kStep).w_world_base() - after(-kStep).w_world_base()) / (2.0 * kStep);
  BOOST_TEST((now.R_world_base() * (rows.A * f - rows.b) - happens).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(tasks_ask_for_nothing_at_their_target, Pushed) {
  const Reference reference = reference_at(robot, state);
  BOOST_TEST(com_acceleration(Gains(), reference, now).norm() < 1e-9);
  BOOST_TEST(base_angular_acceleration(Gains(), reference, now).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(orientation_error_pulls_back_along_the_axis_it_was_turned_about, Pushed) {
  Reference reference = reference_at(robot, state);
  const Vector3 axis(0.3, -0.2, 0.0);  // world, radians
  reference.R_world_base = exp_so3(axis) * reference.R_world_base;
  const Vector3 alpha = base_angular_acceleration(Gains(), reference, now);
  BOOST_TEST((alpha - Gains().base_kp_tilt * axis).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(a_foot_off_its_anchor_is_pulled_back_and_damped, Pushed) {
  Reference reference = reference_at(robot, state);
  const Vector3 offset(0.01, -0.02, 0.005);
  reference.feet[RR_].p_world += offset;
  const FeetMatrix a = feet_accelerations(Gains(), reference, now);
  const Vector3 expected =
      Gains().foot_kp * offset - Gains().foot_kd * now.legs()[RR_].v_world_contact;
  BOOST_TEST((a.col(RR_) - expected).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(even_forces_meet_both_tasks_and_are_the_shortest_that_do, Pushed) {
  const TaskRows com = com_task(Gains(), Vector3(0.3, -0.2, 0.1), robot.mass());
  const TaskRows turn = base_orientation_task(Gains(), Vector3(1.0, 2.0, -1.0), now, condensed);
  const Vector12 even = even_forces(com, turn, Eigen::Vector4d::Ones());
  BOOST_TEST((com.A * even - com.b).norm() < 1e-5);
  BOOST_TEST((turn.A * even - turn.b).norm() < 1e-5);
  Eigen::Matrix<double, 6, 12> A;
  A << com.A, turn.A;
  const Eigen::MatrixXd kernel = Eigen::FullPivLU<Eigen::MatrixXd>(A).kernel();
  BOOST_TEST((kernel.transpose() * even).cwiseAbs().maxCoeff() < 1e-4 * even.norm());
}

BOOST_FIXTURE_TEST_CASE(a_foot_without_share_gets_no_even_force, Pushed) {
  const TaskRows com = com_task(Gains(), Vector3::Zero(), robot.mass());
  const TaskRows turn = base_orientation_task(Gains(), Vector3::Zero(), now, condensed);
  const Vector12 even = even_forces(com, turn, Eigen::Vector4d(1.0, 1.0, 0.0, 1.0));
  BOOST_TEST(even.segment<3>(3 * RR_).norm() == 0.0);
  BOOST_TEST((com.A * even - com.b).norm() < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
