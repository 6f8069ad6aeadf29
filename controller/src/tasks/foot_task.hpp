// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the desired acceleration of each contact point, world axes [m/s^2], one column per foot:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v)
/// For a stance foot, p_ref is its desired position on the ground, and the feedback stabilises the
/// contact. A stance foot without load gets stiffer feedback than the gains, because no friction of
/// the ground holds it against the friction of its joints.
/// The QP meets these accelerations exactly, except near a singularity, and its solution includes
/// the reaction of the legs on the body.
/// Real-time: yes.
/// @param unloaded result of unloaded_shares(), or zeros
FeetMatrix feet_accelerations(const Gains& gains, const Reference& reference,
                              const Dynamics& dynamics, const Eigen::Vector4d& unloaded) noexcept;

/// Return for each foot how far it stands without load, 0 .. 1. A foot that has lost its contact
/// counts as 0: something has lifted it, and the robot must not press it down. Real-time: yes.
/// @param loads planned normal force of each foot, as a share of the weight
/// @param contact contact confidence per foot, 0 .. 1
Eigen::Vector4d unloaded_shares(const Eigen::Vector4d& loads,
                                const Eigen::Vector4d& contact) noexcept;

}  // namespace surefoot
