// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// What the joints can give and may do at this instant, in the rows of a JointTable.
struct JointLimits {
  explicit JointLimits(int size)
      : tau_lower(Eigen::VectorXd::Zero(size)),
        tau_upper(tau_lower),
        a_lower(tau_lower),
        a_upper(tau_lower),
        a_released(tau_lower) {}
  Eigen::VectorXd tau_lower, tau_upper;  ///< [N.m]
  Eigen::VectorXd a_lower, a_upper;      ///< [rad/s^2] that keep position and velocity in range
  Eigen::VectorXd a_released;  ///< [rad/s^2] either way that the body may ask beyond those:
                               ///< release_unloaded_legs()
};

/// Torques by the motors' torque-speed curve; accelerations by the approach to each limit,
///   a <= r^2 (q_upper - margin - q) - 2 r dq   and   a <= r (dq_max - dq),
/// and the same below. Lower <= upper always. Real-time: yes.
/// @param share of each motor's torque that may be used, 0 .. 1, SDK order
void joint_limits(const RobotConfig& config, const JointTable& joints, const Gains& gains,
                  const Vector12& share, const RobotState& state, JointLimits& out) noexcept;

}  // namespace surefoot
