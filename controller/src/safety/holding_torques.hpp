// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Torques that hold a standing robot, the most evenly that its feet allow:
///   tau_leg = h_leg - J_leg^T f,   sum f = m g up - f_sustained,   sum (p - c) x f =
///   -moment_external
/// with what Coriolis and centrifugal forces take included (h). Friction and torque limits are not
/// looked at; a foot that would have to pull carries nothing.
/// @param mass [kg] @param state of which what comes from outside is read @param share how much of
/// the load each foot may take, 0 .. 1, FR FL RR RL
/// @return shape (12,), SDK motor order [N.m]. Real-time: yes.
Vector12 holding_torques(const Dynamics& dynamics, double mass, const RobotState& state,
                         const Eigen::Vector4d& share) noexcept;

}  // namespace surefoot
