// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/types.hpp"
#include "wbc/joint_table.hpp"

namespace surefoot {

/// What the joints can give and may do at this instant, in the rows of a JointTable.
struct JointLimits {
  explicit JointLimits(int size)
      : tau_lower(Eigen::VectorXd::Zero(size)),
        tau_upper(tau_lower),
        a_lower(tau_lower),
        a_upper(tau_lower),
        more(tau_lower) {}
  Eigen::VectorXd tau_lower, tau_upper;  ///< [N.m]
  Eigen::VectorXd a_lower, a_upper;      ///< [rad/s^2] that keep position and velocity in range
  Eigen::VectorXd more;  ///< [rad/s^2] either way that the body may ask beyond those: let_go()
};

/// Share of a foot's load that it is meant to bear, 0 .. 1; none in swing. Real-time: yes.
inline double planned_load(const FootReference& foot) noexcept {
  return foot.stance ? std::clamp(foot.load, 0.0, 1.0) : 0.0;
}

/// Torques by the motors' torque-speed curve; accelerations by the approach to each limit,
///   a <= r^2 (q_upper - margin - q) - 2 r dq   and   a <= r (dq_max - dq),
/// and the same below. Lower <= upper always. Real-time: yes.
/// @param share of each motor's torque that may be used, 0 .. 1, SDK order
void joint_limits(const RobotConfig& config, const JointTable& joints, const Gains& gains,
                  const Vector12& share, const RobotState& state, JointLimits& out) noexcept;

/// Greatest normal force of each foot [N], FR FL RR RL. Real-time: yes.
///
/// It goes smoothly with the planned load and the belief that the foot is on the ground, never to
/// nothing while it is meant to stand: a foot wrongly believed lifted must be able to show its
/// load. 0 in swing.
Eigen::Vector4d normal_force_limits(const Gains& gains, double weight,
                                    const Eigen::Vector4d& contact,
                                    const Reference& reference) noexcept;

/// Share of the even load each foot is offered, 0 .. 1, by the same belief. Real-time: yes.
Eigen::Vector4d load_shares(const Gains& gains, const Eigen::Vector4d& contact,
                            const Reference& reference) noexcept;

}  // namespace surefoot
