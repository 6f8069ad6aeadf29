// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "wbc/joint_limits.hpp"

namespace surefoot {

// Released legs: near the support edge, and while the robot steps, the QP releases a leg whose foot
// carries no load. The QP meets foot accelerations exactly. So a stretched leg at its joint limit
// limits the motion of the body, even if its foot carries no load. With the capture point at the
// support edge, a stretched front leg without load would turn the robot over the rear foot that
// still carries load. While the robot steps, a swing foot with a target that its joints cannot
// reach would make the QP accelerate the body instead. The three functions below prevent this. In
// each tick they run in this order:
//   1. release_unloaded_legs() widens the joint acceleration limits of the leg in the QP;
//   2. limit_foot_accelerations() reduces the desired foot acceleration to what the leg can do;
//   3. clamp_released_legs() applies the leg's own limits to the solution of the QP.

/// Widen the joint acceleration limits of unloaded legs, so that they do not limit the body:
///   limits.a_widening = 1e4 rad/s^2 share (1 - load),   load = planned load * contact
/// The share is 1 while the robot steps. Otherwise it is 1 - fade: 0 away from the support edge.
/// For loaded feet, a_widening is 0. Real-time: yes.
/// @param fade result of edge_fade(), 0 .. 1
/// @param contact contact confidence of each foot, 0 .. 1, FR FL RR RL
/// @param reference planned load of each foot, and whether the robot steps
void release_unloaded_legs(const JointTable& joints, double fade, const Eigen::Vector4d& contact,
                           const Reference& reference, JointLimits& limits) noexcept;

/// Reduce the desired foot accelerations of released legs to what their joints can do.
///
/// The QP meets foot accelerations exactly, and its solution includes the reaction of the legs on
/// the body. If a stretched leg cannot produce its acceleration, this reaction is missing and the
/// robot tips over. Assumption: the base does not accelerate, because its acceleration is unknown
/// before the QP is solved.
/// Real-time: yes.
/// @param smallest_determinant [m^3] released legs with a smaller |det J| are not changed
/// @param feet_acceleration in and out, world axes [m/s^2]
void limit_foot_accelerations(const Dynamics& dynamics, const JointLimits& limits,
                              double smallest_determinant, FeetMatrix& feet_acceleration) noexcept;

/// Limit the accelerations of released legs, in the solution of the QP, to the joint limits without
/// widening.
///
/// If one joint reaches its limit, the accelerations of the leg's other joints change too, so that
/// the foot acceleration stays as close as possible to the solution (least squares). If each joint
/// were clamped separately, the thigh of a leg with a stretched knee would swing the leg forward,
/// where it can hit a stance leg. Torques change by tau += M_leg (a_clamped - a). The reaction on
/// the body is small and is neglected. Real-time: yes.
/// @param accelerations in and out, shape (nv,), Pinocchio's order
/// @param torques in and out [N.m], SDK motors first
void clamp_released_legs(const JointTable& joints, const Dynamics& dynamics,
                         const JointLimits& limits, Eigen::VectorXd& accelerations,
                         Eigen::VectorXd& torques) noexcept;

}  // namespace surefoot
