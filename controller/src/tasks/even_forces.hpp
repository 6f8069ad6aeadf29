// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Most even contact forces that meet six rows, such as two tasks of the body:
///   minimise sum |f_i|^2 / share_i   subject to   A f = b
/// Drawn towards them the program meets these tasks exactly while no limit is active, so the weight
/// of this pull is free to serve the program's conditioning.
/// @param share how much of the load each foot may take, 0 .. 1, FR FL RR RL
/// Real-time: yes.
Vector12 even_forces(const Matrix6x12& A, const Vector6& b, const Eigen::Vector4d& share) noexcept;

/// The same for a wrench about the centre of mass:
///   sum f_i = force,  sum (p_i - p_com) x f_i = moment
Vector12 even_forces(const Dynamics& dynamics, const Vector3& force, const Vector3& moment,
                     const Eigen::Vector4d& share) noexcept;

/// Moment about the centre of mass that turns the locked robot: I alpha + w x I w [N.m].
Vector3 turning_moment(const Dynamics& dynamics, const Vector3& alpha_world) noexcept;

}  // namespace surefoot
