// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Acceleration of every contact point, world axes [m/s^2], one column a foot:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v),   |kp (p_ref - p)| <= max(kd, 1) foot_speed
/// For a stance foot p_ref is its anchor: this is the contact stabilisation. It is met exactly, not
/// traded: the gains enter nothing but this acceleration. So a foot that is far off may not be
/// called back at any speed: what its leg cannot do would be counted on to push the body.
/// Real-time: yes.
FeetMatrix feet_accelerations(const Gains& gains, const Reference& reference,
                              const Dynamics& dynamics) noexcept;

}  // namespace surefoot
