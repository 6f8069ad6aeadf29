// SPDX-License-Identifier: BSD-3-Clause
// A robot with an arm on its trunk: the general form accepts it; the condensed form and
// StandController refuse it and say why.
#include <boost/test/unit_test.hpp>

#include "pushed_robot.hpp"
#include "robot/joint_table.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/whole_body_controller.hpp"

using namespace surefoot;

namespace {

template <typename Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

struct RobotWithArm {
  Robot robot = quadruped_with_arm();
  int arm_v = 0, arm_q = 0;
  RobotState state = standing_state(robot);
  RobotWithArm() {
    const JointRow arm = make_joint_table(robot).back();
    arm_v = arm.v;
    arm_q = arm.q;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(extra_joint)

BOOST_FIXTURE_TEST_CASE(arm_joint_row_comes_from_the_model, RobotWithArm) {
  const JointTable joints = make_joint_table(robot);
  BOOST_REQUIRE(joints.size() == 13U);
  const JointRow& arm = joints.back();
  BOOST_TEST(arm.motor == -1);
  BOOST_TEST(arm.group == kLegs);
  BOOST_TEST(arm.tau_max == 5.0);
  BOOST_TEST(arm.dq_max == 4.0);
  BOOST_TEST(arm.q_lower == -1.0);
  BOOST_TEST(arm.q_upper == 1.0);
}

BOOST_FIXTURE_TEST_CASE(equations_of_motion_hold_with_an_arm, RobotWithArm) {
  WholeBodyController controller(robot, Gains(), {QpForm::kAuto, 1e-10});
  for (int seed = 0; seed < 20; ++seed) {
    state = random_state(robot, seed, 1.0);
    const Solution& s = controller.update(state, reference_at(robot, state));
    BOOST_REQUIRE(is_usable(s.status));
    BOOST_TEST((s.form == QpForm::kGeneral));
    Eigen::VectorXd residual = inverse_dynamics(robot, state, s.accelerations);
    residual.tail(robot.nv() - 6) -= s.torques;
    const Dynamics dynamics = dynamics_at(robot, state);
    FullDynamics full(robot.nv());
    dynamics.write_full(full);
    BOOST_TEST((full.M - mass_matrix(robot, state.q)).norm() < 1e-9);
    residual -= full.J.transpose() * s.forces.reshaped();
    BOOST_TEST(residual.cwiseAbs().maxCoeff() < 1e-6);
    for (int leg = 0; leg < kLegs; ++leg) {
      const Vector3 v = full.J.middleRows<3>(3 * leg) * state.v;
      BOOST_TEST((v - dynamics.legs()[leg].v_world_contact).norm() < 1e-9);
    }
  }
}

// The released legs and the estimate of the foot forces use these blocks.
BOOST_FIXTURE_TEST_CASE(leg_blocks_match_the_full_mass_matrix, RobotWithArm) {
  state = random_state(robot, 5, 1.0);
  const Eigen::MatrixXd M = mass_matrix(robot, state.q);
  const Dynamics dynamics = dynamics_at(robot, state);
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& now = dynamics.legs()[leg];
    for (int i = 0; i < kLegJoints; ++i) {
      const int row = robot.motor_to_v()[kLegJoints * leg + i];
      BOOST_TEST((now.M_base_leg.col(i) - M.col(row).head<6>()).norm() < 1e-12);
      for (int j = 0; j < kLegJoints; ++j) {
        const int column = robot.motor_to_v()[kLegJoints * leg + j];
        BOOST_TEST(std::abs(now.M_leg(i, j) - M(row, column)) < 1e-12);
      }
    }
  }
}

// Three seconds of an ideal robot: it stands, and the arm moves to its posture within its limit.
BOOST_FIXTURE_TEST_CASE(robot_stands_and_the_arm_stops_at_its_joint_limit, RobotWithArm) {
  WholeBodyController controller(robot);
  Reference reference = controller.hold(state);
  reference.posture[arm_v - 6] = 3.0;  // beyond the joint limit
  const Vector3 p_com = reference.p_com;
  const double dt = 0.002;
  double max_arm_speed = 0.0;
  for (int k = 0; k < 1500; ++k) {
    const Solution& s = controller.update(state, reference);
    BOOST_REQUIRE(is_usable(s.status));
    BOOST_REQUIRE(std::abs(s.torques[arm_v - 6]) <= 5.0 + 1e-9);
    state.q = integrate(robot, state.q, dt * state.v + 0.5 * dt * dt * s.accelerations);
    state.v += dt * s.accelerations;
    BOOST_REQUIRE(state.q[arm_q] <= 1.0);
    max_arm_speed = std::max(max_arm_speed, state.v[arm_v]);
  }
  BOOST_TEST(state.q[arm_q] > 1.0 - 2.0 * Gains().joint_limit_margin);
  BOOST_TEST(max_arm_speed <= 4.0 + 1e-6);
  BOOST_TEST((center_of_mass(robot, state.q) - p_com).norm() < 2e-3);
  BOOST_TEST(state.v.norm() < 0.05);
}

BOOST_FIXTURE_TEST_CASE(condensed_form_and_stand_controller_refuse_an_arm, RobotWithArm) {
  const std::string condensed =
      error_of([&] { WholeBodyController(robot, Gains(), {QpForm::kCondensed}); });
  BOOST_TEST(condensed.find("testdog") != std::string::npos);
  BOOST_TEST(condensed.find("condensed") != std::string::npos);
  BOOST_TEST(condensed.find("nv = 19") != std::string::npos);
  const std::string stand = error_of([&] { StandController{robot}; });
  BOOST_TEST(stand.find("testdog") != std::string::npos);
  BOOST_TEST(stand.find("for a Controller") != std::string::npos);
  BOOST_TEST(stand.find("nv = 19") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
