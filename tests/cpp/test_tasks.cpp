// SPDX-License-Identifier: BSD-3-Clause
// Every task's rows against the motion that happens, by finite differences along it.
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include "motion.hpp"
#include "tasks/base_orientation_task.hpp"
#include "tasks/base_position_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/foot_task.hpp"
#include "tasks/momentum_task.hpp"
#include "tasks/posture_task.hpp"

using namespace surefoot;

namespace {

// What the rows say happens, beyond what they ask for.
Vector3 said(const BodyRows& rows, const Pushed& p) {
  return rows.A_base * p.a.head<6>() + rows.A_force * p.f - rows.b;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tasks)

BOOST_FIXTURE_TEST_CASE(centre_of_mass_rows_give_the_acceleration_that_happens, Pushed) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.v_world_com(); });
  const Vector3 asked(0.3, -0.2, 0.1);
  const BodyRows rows = com_task(Gains(), asked, f_outside, robot.mass());
  BOOST_TEST((said(rows, *this) - (happens - asked)).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(base_rows_give_the_acceleration_of_its_origin_that_happens, Pushed) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.v_world_base(); });
  const Vector3 asked(0.3, -0.2, 0.1);
  const BodyRows rows = base_position_task(Gains(), asked, now);
  BOOST_TEST((said(rows, *this) - (happens - asked)).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(base_rows_say_the_same_in_a_frame_that_was_shifted, Pushed) {
  RobotState resting = state;
  resting.q.head<3>().setZero();
  resting.v.head<3>().setZero();
  Dynamics shifted = dynamics_at(robot, resting);
  shifted.shift(state.q.head<3>(), now.v_world_base());
  // The frame's own base acceleration lacks what shift() says.
  Vector6 a_base = a.head<6>();
  a_base.head<3>() -= shifted.a_base_shift();
  const BodyRows rows = base_position_task(Gains(), Vector3::Zero(), shifted);
  const Vector3 happens = rate([](const Dynamics& d) { return d.v_world_base(); });
  BOOST_TEST(shifted.a_base_shift().norm() > 1e-3);
  BOOST_TEST((rows.A_base * a_base - rows.b - happens).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(orientation_rows_give_the_angular_acceleration_that_happens, Pushed) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.w_world_base(); });
  const Vector3 asked(1.0, 2.0, -1.0);
  const BodyRows rows = base_orientation_task(Gains(), asked, now);
  BOOST_TEST((said(rows, *this) - (happens - asked)).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(momentum_rows_give_the_change_of_momentum_that_happens, Pushed) {
  const Vector3 happens = rate([](const Dynamics& d) { return d.L_world_com(); });
  Reference reference;
  reference.Ldot_com = Vector3(0.2, -0.1, 0.3);
  reference.L_com = Vector3(0.05, 0.02, -0.04);
  const Vector3 asked =
      reference.Ldot_com + Gains().momentum_kd * (reference.L_com - now.L_world_com());
  BOOST_TEST((said(momentum_task(Gains(), reference, now), *this) - (happens - asked)).norm() <
             1e-5);
}

BOOST_FIXTURE_TEST_CASE(tasks_ask_for_nothing_at_their_target, Pushed) {
  const Reference reference = reference_at(robot, state);
  BOOST_TEST(com_acceleration(Gains(), reference, now).norm() < 1e-9);
  BOOST_TEST(base_acceleration(Gains(), reference, now).norm() < 1e-9);
  BOOST_TEST(base_angular_acceleration(Gains(), reference, now).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(orientation_error_pulls_back_along_the_axis_it_was_turned_about, Pushed) {
  Reference reference = reference_at(robot, state);
  const Vector3 axis(0.3, -0.2, 0.0);  // world, radians
  reference.R_world_base = exp_so3(axis) * reference.R_world_base;
  const Vector3 alpha = base_angular_acceleration(Gains(), reference, now);
  BOOST_TEST((alpha - Gains().base_kp_tilt * axis).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(a_base_off_its_place_is_pulled_back_and_damped_axis_by_axis, Pushed) {
  Reference reference = reference_at(robot, state);
  reference.p_base += Vector3(0.01, -0.02, 0.03);
  reference.v_base += Vector3(0.1, 0.2, -0.1);
  reference.a_base = Vector3(1.0, 2.0, 3.0);
  const Gains g;
  const Vector3 expected(1.0 + g.com_kp_horizontal * 0.01 + g.com_kd_horizontal * 0.1,
                         2.0 - g.com_kp_horizontal * 0.02 + g.com_kd_horizontal * 0.2,
                         3.0 + g.com_kp_vertical * 0.03 - g.com_kd_vertical * 0.1);
  BOOST_TEST((base_acceleration(g, reference, now) - expected).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(a_foot_off_its_anchor_is_pulled_back_and_damped, Pushed) {
  Reference reference = reference_at(robot, state);
  const Vector3 offset(0.01, -0.02, 0.005);
  reference.feet[RR_].p_world += offset;
  const FeetMatrix wanted = feet_accelerations(Gains(), reference, now);
  const Vector3 expected =
      Gains().foot_kp * offset - Gains().foot_kd * now.legs()[RR_].v_world_contact;
  BOOST_TEST((wanted.col(RR_) - expected).norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(a_foot_far_off_its_anchor_is_pulled_back_at_foot_speed_and_no_faster,
                        Pushed) {
  Reference reference = reference_at(robot, state);
  const Vector3 offset(0.1, -0.2, 0.2);
  reference.feet[RR_].p_world += offset;
  Gains gains;
  gains.foot_speed = 1.0;
  const Vector3 expected =
      gains.foot_kd * (offset / offset.norm() - now.legs()[RR_].v_world_contact);
  BOOST_TEST((feet_accelerations(gains, reference, now).col(RR_) - expected).norm() < 1e-9);
  for (const double kd : {0.0, 0.01}) {
    gains.foot_kd = kd;
    const Vector3 pull = offset / offset.norm() - kd * now.legs()[RR_].v_world_contact;
    BOOST_TEST((feet_accelerations(gains, reference, now).col(RR_) - pull).norm() < 1e-9);
  }
}

// Order is what can go wrong here: q, v, posture and the table each have their own.
BOOST_FIXTURE_TEST_CASE(joints_that_obey_the_posture_task_end_at_the_posture_each_at_its_own,
                        Pushed) {
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
