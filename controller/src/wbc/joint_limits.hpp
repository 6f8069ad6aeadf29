// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Limits on joint torques and accelerations in the present state, in the order of a JointTable.
struct JointLimits {
  explicit JointLimits(int size)
      : tau_lower(Eigen::VectorXd::Zero(size)),
        tau_upper(tau_lower),
        a_lower(tau_lower),
        a_upper(tau_lower),
        a_widening(tau_lower) {}
  Eigen::VectorXd tau_lower, tau_upper;  ///< [N.m]
  /// [rad/s^2] Limits that keep joint position and velocity in range.
  Eigen::VectorXd a_lower, a_upper;
  /// [rad/s^2] Amount by which a_lower and a_upper are widened in the QP for a released leg; 0: not
  /// released. See release_unloaded_legs().
  Eigen::VectorXd a_widening;
};

/// Compute the joint limits. Torque limits follow the motors' torque-speed curve. Acceleration
/// limits make each joint approach its position and velocity limits smoothly:
///   a <= r^2 (q_upper - margin - q) - 2 r dq   and   a <= r (dq_max - dq),   r: below
/// and likewise for the lower limits. Lower <= upper always holds. a_widening is set to zero.
/// Real-time: yes.
/// @param stepping selects r: gain joint_limit_rate, or walk_joint_limit_rate [1/s] if true
/// @param share usable share of each motor's torque, 0 .. 1, SDK motor order
void joint_limits(const RobotConfig& config, const JointTable& joints, const Gains& gains,
                  bool stepping, const Vector12& share, const RobotState& state,
                  JointLimits& out) noexcept;

}  // namespace surefoot
