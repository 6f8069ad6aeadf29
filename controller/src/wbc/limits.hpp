// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot_config.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Columns lower, upper; rows in SDK motor order [N.m].
using TorqueLimits = Eigen::Matrix<double, kMotors, 2>;

/// What the motors can give at these joint velocities, SDK motor order [rad/s]. Real-time: yes.
TorqueLimits torque_limits(const RobotConfig& config, const Vector12& dq) noexcept;

/// Greatest normal force of each foot [N], FR FL RR RL. Real-time: yes.
///
/// It goes smoothly with the belief that the foot is on the ground, never to nothing while it is
/// meant to stand: a foot wrongly believed lifted must be able to show its load. 0 in swing.
Eigen::Vector4d normal_force_limits(const Gains& gains, double weight,
                                    const Eigen::Vector4d& contact,
                                    const Reference& reference) noexcept;

/// Share of the even load each foot is offered, 0 .. 1, by the same belief. Real-time: yes.
Eigen::Vector4d load_shares(const Gains& gains, const Eigen::Vector4d& contact,
                            const Reference& reference) noexcept;

}  // namespace surefoot
