// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Most even contact forces that make the wanted motion of the body:
///   minimise sum |f_i|^2 / share_i   subject to   sum f_i = force,  sum (p_i - p_com) x f_i =
///   moment
/// The program is drawn towards them: they agree with its tasks (but for the legs' own inertia in
/// `moment`), so that the weight of this pull is free to serve the program's conditioning.
/// @param share how much of the load each foot may take, 0 .. 1, FR FL RR RL
/// Real-time: yes.
Vector12 even_forces(const Dynamics& dynamics, const Vector3& force, const Vector3& moment,
                     const Eigen::Vector4d& share) noexcept;

/// Moment about the centre of mass that turns the locked robot: I alpha + w x I w [N.m].
Vector3 turning_moment(const Dynamics& dynamics, const Vector3& alpha_world) noexcept;

}  // namespace surefoot
