// SPDX-License-Identifier: BSD-3-Clause
#include "quadruped.hpp"

#include <pinocchio/algorithm/center-of-mass.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

using namespace surefoot;

namespace {

const char* const kLegNames[] = {"FR", "FL", "RR", "RL"};

pinocchio::SE3 at(double x, double y, double z) { return {Matrix3::Identity(), Vector3(x, y, z)}; }

void add_leg(pinocchio::Model& model, pinocchio::JointIndex base, int leg) {
  const std::string name = kLegNames[leg];
  const double side = leg % 2 ? 1.0 : -1.0, front = leg < 2 ? 1.0 : -1.0;
  const auto link = pinocchio::Inertia::FromSphere(0.6, 0.04);
  const auto rod =
      pinocchio::Inertia(0.4, Vector3(0.003, 0.0, -0.09), Vector3(2e-3, 2e-3, 1e-4).asDiagonal());
  const auto hip = model.addJoint(base, pinocchio::JointModelRX(), at(0.18 * front, 0.05 * side, 0),
                                  name + "_hip_joint");
  model.appendBodyToJoint(hip, link);
  const auto thigh =
      model.addJoint(hip, pinocchio::JointModelRY(), at(0, 0.08 * side, 0), name + "_thigh_joint");
  model.appendBodyToJoint(thigh, link, at(0.0, 0.0, -0.03));
  const auto calf =
      model.addJoint(thigh, pinocchio::JointModelRY(), at(0, 0, -0.2), name + "_calf_joint");
  model.appendBodyToJoint(calf, rod);
  model.addFrame(pinocchio::Frame(name + "_foot", calf, 0, at(0.0, 0.0, -0.2), pinocchio::BODY));
}

}  // namespace

RobotConfig quadruped_config() {
  RobotConfig config;
  config.name = "testdog";
  const char* joints[] = {"_hip_joint", "_thigh_joint", "_calf_joint"};
  const Vector3 pose(0.0, 0.8, -1.6), lower(-0.9, -1.0, -2.7), upper(0.9, 3.0, -0.8);
  for (int leg = 0; leg < kLegs; ++leg) {
    config.foot_frames[leg] = std::string(kLegNames[leg]) + "_foot";
    for (int k = 0; k < 3; ++k) {
      const int i = 3 * leg + k;
      config.joint_names[i] = kLegNames[leg] + std::string(joints[k]);
      config.q_standing[i] = pose[k];
      config.q_lower[i] = lower[k];
      config.q_upper[i] = upper[k];
    }
  }
  config.foot_radius = 0.02;
  config.dq_max.setConstant(25.0);
  config.tau_max.setConstant(30.0);
  config.corner_speed.setConstant(12.0);
  config.no_load_speed.setConstant(25.0);
  config.armature.setConstant(0.005);
  return config;
}

Robot quadruped() {
  pinocchio::Model model;
  const auto base = model.addJoint(0, pinocchio::JointModelFreeFlyer(), at(0, 0, 0), "root_joint");
  model.appendBodyToJoint(base, pinocchio::Inertia::FromBox(5.6, 0.4, 0.2, 0.1));
  for (const int leg : {FL_, FR_, RL_, RR_}) add_leg(model, base, leg);
  return Robot(model, quadruped_config());
}

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

Reference reference_at(const Robot& robot, const RobotState& state) {
  pinocchio::Data data(robot.model());
  Reference reference;
  reference.p_com = pinocchio::centerOfMass(robot.model(), data, state.q, state.v);
  reference.v_com = data.vcom[0];
  const Quaternion R(state.q[6], state.q[3], state.q[4], state.q[5]);
  reference.R_world_base = R;
  reference.w_world_base = R * Vector3(state.v.segment<3>(3));
  pinocchio::framesForwardKinematics(robot.model(), data, state.q);
  for (int leg = 0; leg < kLegs; ++leg) {
    reference.feet[leg].p_world = data.oMf[robot.foot_frame_ids()[leg]].translation() -
                                  robot.config().foot_radius * reference.ground_normal;
  }
  return reference;
}

LowState resting_report(const Robot& robot, std::uint32_t tick) {
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
