// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the desired acceleration of each contact point, world axes [m/s^2], one column per foot:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v),   |kp (p_ref - p)| <= max(kd, 1) foot_speed
/// For a stance foot, p_ref is its anchor, and the feedback is the contact stabilisation.
/// The QP meets these accelerations exactly (except near a singularity) and counts on the reaction
/// of the legs on the body. A foot far from its reference must therefore not be accelerated more
/// than its leg can do: foot_speed limits its return. Real-time: yes.
FeetMatrix feet_accelerations(const Gains& gains, const Reference& reference,
                              const Dynamics& dynamics) noexcept;

}  // namespace surefoot
