// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the desired joint accelerations [rad/s^2] of the posture task, in the order of a
/// JointTable:
///   a = kp (q_ref - q) - kd dq
/// Joints without a single angle (joint.q < 0) get no kp term.
/// @param posture q_ref, shape (nv - 6,), order of v[6:]; empty: the standing pose
/// @param out shape (joints.size(),)
/// Real-time: yes.
void posture_accelerations(const Gains& gains, const JointTable& joints, const RobotState& state,
                           const Eigen::VectorXd& posture, Eigen::VectorXd& out) noexcept;

}  // namespace surefoot
