// SPDX-License-Identifier: BSD-3-Clause
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/multibody.hpp>

#include "robot/robot_checks.hpp"

namespace surefoot {

namespace {

// Return the distance of a point from a line.
double distance(const Vector3& point, const Vector3& on_line, const Vector3& axis) {
  return (point - on_line).cross(axis).norm();
}

}  // namespace

std::array<LegPlaces, kLegs> measure_legs(const RobotParts& parts) {
  const auto& model = parts.model;
  pinocchio::Data data(model);
  Eigen::VectorXd q = pinocchio::neutral(model);
  std::array<LegPlaces, kLegs> legs;
  pinocchio::computeJointJacobians(model, data, q);
  for (int i = 0; i < kMotors; ++i) {
    legs[i / kLegJoints].axes[i % kLegJoints] = data.J.col(parts.motor_to_v[i]).tail<3>();
  }
  for (int i = 0; i < kMotors; ++i) q[parts.motor_to_q[i]] = parts.config.q_standing[i];
  pinocchio::computeJointJacobians(model, data, q);
  pinocchio::updateFramePlacements(model, data);
  for (int i = 0; i < kMotors; ++i) {
    const auto joint = model.getJointId(parts.config.joint_names[i]);
    legs[i / kLegJoints].joints[i % kLegJoints] = data.oMi[joint].translation();
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    LegPlaces& L = legs[leg];
    const int v = parts.motor_to_v[kLegJoints * leg + 2];
    const Vector3 calf_axis = data.J.col(v).tail<3>();
    L.foot = data.oMf[parts.foot_frame_ids[leg]].translation();
    L.thigh = distance(L.joints[1], L.joints[2], calf_axis);
    L.calf = distance(L.foot, L.joints[2], calf_axis);
  }
  return legs;
}

}  // namespace surefoot
