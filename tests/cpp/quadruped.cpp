// SPDX-License-Identifier: BSD-3-Clause
#include "quadruped.hpp"

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

pinocchio::Model quadruped_model() {
  pinocchio::Model model;
  const auto base = model.addJoint(0, pinocchio::JointModelFreeFlyer(), at(0, 0, 0), "root_joint");
  model.appendBodyToJoint(base, pinocchio::Inertia::FromBox(5.6, 0.4, 0.2, 0.1));
  for (const int leg : {FL_, FR_, RL_, RR_}) add_leg(model, base, leg);
  return model;
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

Robot quadruped(const RobotConfig& config) { return Robot(quadruped_model(), config); }

Robot quadruped_with_arm() {
  pinocchio::Model model = quadruped_model();
  const auto arm =
      model.addJoint(1, pinocchio::JointModelRY(), at(0.1, 0, 0.05), "arm_joint",
                     Eigen::VectorXd::Constant(1, 5.0), Eigen::VectorXd::Constant(1, 4.0),
                     Eigen::VectorXd::Constant(1, -1.0), Eigen::VectorXd::Constant(1, 1.0));
  model.appendBodyToJoint(arm, pinocchio::Inertia::FromSphere(0.5, 0.05), at(0.15, 0, 0.1));
  return Robot(model, quadruped_config());
}
