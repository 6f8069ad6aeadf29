// SPDX-License-Identifier: BSD-3-Clause
// Compare the rows of each task with the motion, by finite differences.
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include "pushed_robot.hpp"
#include "tasks/base_orientation_task.hpp"
#include "tasks/base_position_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/foot_task.hpp"
#include "tasks/momentum_task.hpp"
#include "tasks/posture_task.hpp"

using namespace surefoot;

namespace {

// Return the acceleration by the rows minus the requested acceleration.
Vector3 row_error(const BodyRows& rows, const PushedRobot& p) {
  return rows.A_base * p.a.head<6>() + rows.A_force * p.f - rows.b;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tasks)

BOOST_FIXTURE_TEST_CASE(com_rows_match_finite_differences, PushedRobot) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.v_world_com(); });
  const Vector3 desired(0.3, -0.2, 0.1);
  const BodyRows rows = com_task(Gains(), desired, f_external, robot.mass());
  BOOST_TEST((row_error(rows, *this) - (happens - desired)).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(base_position_rows_match_finite_differences, PushedRobot) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.v_world_base(); });
  const Vector3 desired(0.3, -0.2, 0.1);
  const BodyRows rows = base_position_task(Gains(), desired, dynamics);
  BOOST_TEST((row_error(rows, *this) - (happens - desired)).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(base_position_rows_match_in_a_shifted_frame, PushedRobot) {
  RobotState resting = state;
  resting.q.head<3>().setZero();
  resting.v.head<3>().setZero();
  Dynamics shifted = dynamics_at(robot, resting);
  shifted.shift(state.q.head<3>(), dynamics.v_world_base());
  // The base acceleration in the shifted frame does not include the part from shift().
  Vector6 a_base = a.head<6>();
  a_base.head<3>() -= shifted.a_base_shift();
  const BodyRows rows = base_position_task(Gains(), Vector3::Zero(), shifted);
  const Vector3 happens = rate([](const Dynamics& d) { return d.v_world_base(); });
  BOOST_TEST(shifted.a_base_shift().norm() > 1e-3);
  BOOST_TEST((rows.A_base * a_base - rows.b - happens).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(orientation_rows_match_finite_differences, PushedRobot) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.w_world_base(); });
  const Vector3 desired(1.0, 2.0, -1.0);
  const BodyRows rows = base_orientation_task(Gains(), desired, dynamics, false);
  BOOST_TEST((row_error(rows, *this) - (happens - desired)).norm() < 1e-5);
  const Gains gains;
  const double tilt = gains.weight_base_tilt;
  BOOST_TEST((rows.weight == Vector3(tilt, tilt, gains.weight_base_yaw)));
  const BodyRows stepping = base_orientation_task(gains, desired, dynamics, true);
  BOOST_TEST((stepping.weight == Vector3::Constant(gains.walk_weight_base_rotation)));
}

BOOST_FIXTURE_TEST_CASE(momentum_rows_match_finite_differences, PushedRobot) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.L_world_com(); });
  Reference reference;
  reference.Ldot_com = Vector3(0.2, -0.1, 0.3);
  reference.L_com = Vector3(0.05, 0.02, -0.04);
  const Vector3 desired =
      reference.Ldot_com + Gains().momentum_kd * (reference.L_com - dynamics.L_world_com());
  BOOST_TEST(
      (row_error(momentum_task(Gains(), reference, dynamics), *this) - (happens - desired)).norm() <
      1e-5);
}

BOOST_FIXTURE_TEST_CASE(tasks_request_zero_acceleration_at_their_target, PushedRobot) {
  const Reference reference = reference_at(robot, state);
  BOOST_TEST(com_acceleration(Gains(), reference, dynamics).norm() < 1e-9);
  BOOST_TEST(base_acceleration(Gains(), reference, dynamics).norm() < 1e-9);
  BOOST_TEST(base_angular_acceleration(Gains(), reference, dynamics).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(orientation_feedback_acts_about_the_error_axis, PushedRobot) {
  Reference reference = reference_at(robot, state);
  const Vector3 axis(0.3, -0.2, 0.0);  // world, radians
  reference.R_world_base = exp_so3(axis) * reference.R_world_base;
  const Vector3 alpha = base_angular_acceleration(Gains(), reference, dynamics);
  BOOST_TEST((alpha - Gains().base_kp_tilt * axis).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(base_position_feedback_uses_kp_and_kd_of_each_axis, PushedRobot) {
  Reference reference = reference_at(robot, state);
  reference.p_base += Vector3(0.01, -0.02, 0.03);
  reference.v_base += Vector3(0.1, 0.2, -0.1);
  reference.a_base = Vector3(1.0, 2.0, 3.0);
  const Gains g;
  const Vector3 expected(1.0 + g.com_kp_horizontal * 0.01 + g.com_kd_horizontal * 0.1,
                         2.0 - g.com_kp_horizontal * 0.02 + g.com_kd_horizontal * 0.2,
                         3.0 + g.com_kp_vertical * 0.03 - g.com_kd_vertical * 0.1);
  BOOST_TEST((base_acceleration(g, reference, dynamics) - expected).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(foot_feedback_uses_foot_kp_and_foot_kd, PushedRobot) {
  Reference reference = reference_at(robot, state);
  const Vector3 offset(0.01, -0.02, 0.005);
  reference.feet[RR_].p_world += offset;
  const FeetMatrix wanted = feet_accelerations(Gains(), reference, dynamics);
  const Vector3 expected =
      Gains().foot_kp * offset - Gains().foot_kd * dynamics.legs()[RR_].v_world_contact;
  BOOST_TEST((wanted.col(RR_) - expected).norm() < 1e-9);
}

// The joint orders of q, v, posture and joint table differ and must not be mixed up.
BOOST_FIXTURE_TEST_CASE(posture_task_drives_each_joint_to_its_own_target, PushedRobot) {
  const JointTable joints = make_joint_table(robot);
  Eigen::VectorXd posture = Eigen::VectorXd::LinSpaced(kMotors, -0.5, 0.6);
  Eigen::VectorXd wanted(joints.size());
  const double dt = 1e-3;
  for (int k = 0; k < 3000; ++k) {
    posture_accelerations(Gains(), joints, state, posture, wanted);
    for (std::size_t row = 0; row < joints.size(); ++row) {
      state.v[joints[row].v] += dt * wanted[row];
    }
    state.q.tail(kMotors) += dt * state.v.tail(kMotors);
  }
  BOOST_TEST((state.q.tail(kMotors) - posture).norm() < 1e-6);
  posture_accelerations(Gains(), joints, state, Eigen::VectorXd(), wanted);
  for (int i = 0; i < kMotors; ++i) {
    const double error = robot.config().q_standing[i] - state.q[robot.motor_to_q()[i]];
    BOOST_TEST(std::abs(wanted[i] - Gains().posture_kp * error) < 1e-6);
  }
}

BOOST_AUTO_TEST_SUITE_END()
