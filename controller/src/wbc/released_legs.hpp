// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "wbc/joint_limits.hpp"

namespace surefoot {

/// Let the body ask more of the joints of a leg than they may do, where its foot is not worth the
/// body's balance. Real-time: yes.
///
/// Feet keep their places exactly, so a joint that nears its limit holds the body: with the capture
/// point at the edge, one front leg that is stretched and bears nothing turns a robot over its last
/// rear foot. So near the edge a foot that bears nothing is let go of, and the leg keeps its limits
/// by itself; where it can be afforded, feet stay where they are.
/// @param fade as edge_fade() has it
/// @param contact belief that a foot is on the ground, FR FL RR RL
/// @param reference which feet are meant to bear
void release_unloaded_legs(const JointTable& joints, double fade, const Eigen::Vector4d& contact,
                           const Reference& reference, JointLimits& limits) noexcept;

/// Ask of the feet of such legs no more than their joints may do. Real-time: yes.
///
/// What feet are asked is met exactly, and the body counts on what swings them: with a stretched
/// leg called down, on a turn that never comes, and the robot tips over the foot that it trusts in.
/// The body's own acceleration is not known yet, and left out.
/// @param smallest_determinant of a leg's Jacobian [m^3]; a leg under it is left as it is
/// @param feet_acceleration world axes [m/s^2]
void limit_foot_accelerations(const Dynamics& dynamics, const JointLimits& limits,
                              double smallest_determinant, FeetMatrix& feet_acceleration) noexcept;

/// Keep what was asked of such legs within what they may do. Real-time: yes.
///
/// Where a joint may not do its share the others do theirs anew, so that the foot does most nearly
/// what it was asked. A foot thrown up is called down; with its knee stretched, what the thigh was
/// to do beside the knee would fling the leg forward, into the one that stands. Torques change by
/// M_leg times the change alone, for what the body feels of it is little.
/// @param accelerations shape (nv,); @param torques SDK motors first
void clamp_released_legs(const JointTable& joints, const Dynamics& dynamics,
                         const JointLimits& limits, Eigen::VectorXd& accelerations,
                         Eigen::VectorXd& torques) noexcept;

}  // namespace surefoot
