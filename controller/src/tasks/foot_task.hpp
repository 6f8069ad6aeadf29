// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the desired acceleration of each contact point, world axes [m/s^2], one column per foot:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v)
/// For a stance foot, p_ref is its desired position on the ground, and the feedback stabilises the
/// contact.
/// The QP meets these accelerations exactly, except near a singularity, and its solution includes
/// the reaction of the legs on the body.
/// Real-time: yes.
FeetMatrix feet_accelerations(const Gains& gains, const Reference& reference,
                              const Dynamics& dynamics) noexcept;

}  // namespace surefoot
