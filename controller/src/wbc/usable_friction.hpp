// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Share of the robot's friction coefficient that each foot's force may use, FR FL RR RL, 0 .. 1.
/// Real-time: yes.
///
/// The ground is not known to hold what robot.friction says, and feet that push to their cone's
/// edge slide where it does not. So the last third is kept for what takes it: pushes that bring the
/// capture point near the support's edge, by what they push with now, within kAhead.
/// @param mass [kg] of the robot
Eigen::Vector4d usable_friction(const Dynamics& dynamics, const RobotState& state,
                                const Reference& reference, double mass) noexcept;

}  // namespace surefoot
