// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the desired acceleration of the base's origin, world axes [m/s^2]:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v)
/// Real-time: yes.
Vector3 base_acceleration(const Gains& gains, const Reference& reference,
                          const Dynamics& dynamics) noexcept;

/// Compute the rows of the position task of the base's origin: R (a_lin + w x v_lin) = a, world
/// axes. Real-time: yes.
BodyRows base_position_task(const Gains& gains, const Vector3& acceleration,
                            const Dynamics& dynamics) noexcept;

}  // namespace surefoot
