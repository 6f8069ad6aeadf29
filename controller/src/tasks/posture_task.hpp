// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "tasks/body_rows.hpp"

namespace surefoot {

/// Joint accelerations that pull the joints to the posture, in the rows of a JointTable [rad/s^2]:
///   a = kp (q_ref - q) - kd dq
/// @param out shape (table.size(),). Real-time: yes.
void posture_accelerations(const Gains& gains, const JointTable& joints, const RobotState& state,
                           const Eigen::VectorXd& posture, Eigen::VectorXd& out) noexcept;

}  // namespace surefoot
