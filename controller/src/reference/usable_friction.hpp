// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Share of robot.friction that the force of each foot may use, FR FL RR RL, 0 .. 1: no more than
/// state.friction. Real-time: yes.
///
/// The ground is not known to hold what robot.friction says, and feet that push to their cone's
/// edge slide where it does not. So three tenths are kept for what takes them: the capture point,
/// now or after a tenth of a second more of what pushes the body, near the support's edge.
/// @param mass [kg] of the robot
Eigen::Vector4d usable_friction(const Dynamics& dynamics, const RobotState& state,
                                const Reference& reference, double mass) noexcept;

}  // namespace surefoot
