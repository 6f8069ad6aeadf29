// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the most even contact forces that satisfy six rows, for example those of two body tasks:
///   minimise sum |f_i|^2 / share_i   subject to   A f = b
/// The cost of the QP pulls the contact forces towards these even forces. The even forces satisfy
/// the tasks, so this pull causes no task error while no constraint is active. Its weight can
/// therefore be chosen for the conditioning of the QP alone.
/// @param share share of its even load that each foot may carry, 0 .. 1, FR FL RR RL
/// @return forces [N], FR FL RR RL, world axes. Real-time: yes.
Vector12 even_forces(const Matrix6x12& A, const Vector6& b, const Eigen::Vector4d& share) noexcept;

/// Compute the most even contact forces for a wrench about the centre of mass, world axes:
///   sum f_i = force [N],  sum (p_i - p_com) x f_i = moment [N.m]
/// Real-time: yes.
Vector12 even_forces(const Dynamics& dynamics, const Vector3& force, const Vector3& moment,
                     const Eigen::Vector4d& share) noexcept;

/// Compute the moment about the centre of mass that turns the robot with locked joints, world axes:
/// I alpha + w x I w [N.m]. Real-time: yes.
Vector3 turning_moment(const Dynamics& dynamics, const Vector3& alpha_world) noexcept;

}  // namespace surefoot
