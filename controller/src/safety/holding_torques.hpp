// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Compute the torques that hold a standing robot with the most even contact forces f:
///   tau_leg = h_leg - J_leg^T f
///   sum f = m g up - f_sustained,   sum (p - c) x f = -moment_external
/// where c is the centre of mass. h_leg includes Coriolis and centrifugal forces. Friction and
/// torque limits are ignored. A foot that would have to pull on the ground gets no force.
/// Real-time: yes.
/// @param mass mass of the robot [kg]
/// @param state only f_sustained and moment_external are used
/// @param share share of its even load that each foot may carry, 0 .. 1, FR FL RR RL
/// @return shape (12,), SDK motor order [N.m]
Vector12 holding_torques(const Dynamics& dynamics, double mass, const RobotState& state,
                         const Eigen::Vector4d& share) noexcept;

}  // namespace surefoot
