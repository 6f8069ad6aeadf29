// SPDX-License-Identifier: BSD-3-Clause
#include "robot_states.hpp"

#include <pinocchio/algorithm/center-of-mass.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>
#include <random>

using namespace surefoot;

RobotState random_state(const Robot& robot, int seed, double speed) {
  std::mt19937 generator(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  RobotState state(robot.nq(), robot.nv());
  Eigen::VectorXd step(robot.nv());
  for (Eigen::Index i = 0; i < step.size(); ++i) step[i] = 0.15 * uniform(generator);
  for (Eigen::Index i = 0; i < step.size(); ++i) state.v[i] = speed * uniform(generator);
  state.q = robot.q_standing();
  state.q[2] = 0.3;
  state.q = pinocchio::integrate(robot.model(), state.q, step);
  return state;
}

RobotState standing_state(const Robot& robot) {
  RobotState state(robot.nq(), robot.nv());
  state.q = robot.q_standing();
  state.q[2] = -contact_points(robot, state.q).row(2).mean();
  return state;
}

Reference reference_at(const Robot& robot, const RobotState& state) {
  pinocchio::Data data(robot.model());
  Reference reference;
  reference.p_com = pinocchio::centerOfMass(robot.model(), data, state.q, state.v);
  reference.v_com = data.vcom[0];
  const Quaternion R(state.q[6], state.q[3], state.q[4], state.q[5]);
  reference.R_world_base = R;
  reference.w_world_base = R * Vector3(state.v.segment<3>(3));
  reference.p_base = state.q.head<3>();
  reference.v_base = R * Vector3(state.v.head<3>());
  const FeetMatrix feet = contact_points(robot, state.q);
  for (int leg = 0; leg < kLegs; ++leg) reference.feet[leg].p_world = feet.col(leg);
  return reference;
}

LowState resting_sample(const Robot& robot, std::uint32_t tick) {
  pinocchio::Data data(robot.model());
  const Eigen::VectorXd q = robot.q_standing();
  Eigen::VectorXd tau = pinocchio::computeGeneralizedGravity(robot.model(), data, q);
  pinocchio::computeJointJacobians(robot.model(), data, q);
  pinocchio::updateFramePlacements(robot.model(), data);
  for (int leg = 0; leg < kLegs; ++leg) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, robot.nv());
    pinocchio::getFrameJacobian(robot.model(), data, robot.foot_frame_ids()[leg],
                                pinocchio::LOCAL_WORLD_ALIGNED, J);
    tau -= J.row(2).transpose() * robot.mass() * kGravity / kLegs;
  }
  LowState report = init_low_state();
  report.imu.quaternion = {1.0F, 0.0F, 0.0F, 0.0F};
  report.imu.accelerometer = {0.0F, 0.0F, static_cast<float>(kGravity)};
  report.tick = tick;
  for (int i = 0; i < kMotors; ++i) {
    report.motorState[i].mode = kModeServo;
    report.motorState[i].q = static_cast<float>(robot.config().q_standing[i]);
    report.motorState[i].tauEst = static_cast<float>(tau[robot.motor_to_v()[i]]);
  }
  return report;
}

bool motors_brake(const LowCmd& command) {
  bool good = true;
  for (int i = 0; i < kMotors; ++i) {
    const MotorCmd& m = command.motorCmd[i];
    good = good && m.mode == kModeServo && m.Kp == 0.0F && m.Kd > 0.0F && m.tau == 0.0F &&
           m.q == static_cast<float>(PosStopF) && m.dq == 0.0F;
  }
  return good;
}

Eigen::VectorXd integrate(const Robot& robot, const Eigen::VectorXd& q,
                          const Eigen::VectorXd& step) {
  return pinocchio::integrate(robot.model(), q, step);
}

Eigen::MatrixXd mass_matrix(const Robot& robot, const Eigen::VectorXd& q) {
  pinocchio::Data data(robot.model());
  Eigen::MatrixXd M = pinocchio::crba(robot.model(), data, q);
  M.triangularView<Eigen::StrictlyLower>() = M.transpose().triangularView<Eigen::StrictlyLower>();
  return M;
}

Eigen::VectorXd inverse_dynamics(const Robot& robot, const RobotState& state,
                                 const Eigen::VectorXd& a) {
  pinocchio::Data data(robot.model());
  return pinocchio::rnea(robot.model(), data, state.q, state.v, a);
}

Eigen::VectorXd armature(const Robot& robot) { return robot.model().armature; }

FeetMatrix contact_points(const Robot& robot, const Eigen::VectorXd& q) {
  pinocchio::Data data(robot.model());
  pinocchio::framesForwardKinematics(robot.model(), data, q);
  FeetMatrix points;
  for (int leg = 0; leg < kLegs; ++leg) {
    points.col(leg) = data.oMf[robot.foot_frame_ids()[leg]].translation() -
                      robot.config().foot_radius * Vector3::UnitZ();
  }
  return points;
}

Vector3 center_of_mass(const Robot& robot, const Eigen::VectorXd& q) {
  pinocchio::Data data(robot.model());
  return pinocchio::centerOfMass(robot.model(), data, q);
}
