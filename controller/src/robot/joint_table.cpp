// SPDX-License-Identifier: BSD-3-Clause
#include "robot/joint_table.hpp"

#include <algorithm>
#include <pinocchio/multibody.hpp>

namespace surefoot {

namespace {

JointRow motor_row(const Robot& robot, int motor) {
  const RobotConfig& c = robot.config();
  JointRow row;
  row.v = robot.motor_to_v()[motor];
  row.q = robot.motor_to_q()[motor];
  row.motor = motor;
  row.group = motor / kLegJoints;
  const JointRange range = motion_range(c, motor);
  row.q_lower = range.lower;
  row.q_upper = range.upper;
  row.dq_max = c.dq_max[motor];
  row.tau_max = c.tau_max[motor];
  row.q_standing = c.q_standing[motor];
  return row;
}

// A URDF without a limit gives 0 or infinity, but the QP needs a finite number. The function then
// returns 1e4 N.m or rad/s, far above the limit of any motor.
double finite_limit(double limit) { return limit > 0.0 && limit < 1e4 ? limit : 1e4; }

}  // namespace

JointTable make_joint_table(const Robot& robot) {
  JointTable table;
  for (int motor = 0; motor < kMotors; ++motor) table.push_back(motor_row(robot, motor));
  const pinocchio::Model& model = robot.model();
  const Eigen::VectorXd q = robot.q_standing();
  for (std::size_t id = 2; id < static_cast<std::size_t>(model.njoints); ++id) {
    const auto& motors = robot.motor_to_v();
    for (int k = 0; k < model.nvs[id]; ++k) {
      JointRow row;
      row.v = model.idx_vs[id] + k;
      if (std::find(motors.begin(), motors.end(), row.v) != motors.end()) continue;
      row.group = kLegs;
      row.dq_max = finite_limit(model.upperVelocityLimit[row.v]);
      row.tau_max = finite_limit(model.upperEffortLimit[row.v]);
      if (model.nqs[id] == model.nvs[id]) {
        row.q = model.idx_qs[id] + k;
        row.q_lower = model.lowerPositionLimit[row.q];
        row.q_upper = model.upperPositionLimit[row.q];
        row.q_standing = q[row.q];
      }
      table.push_back(row);
    }
  }
  return table;
}

}  // namespace surefoot
