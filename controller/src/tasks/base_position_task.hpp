// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Acceleration that pulls the base's origin to its reference, world axes [m/s^2]:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v)
/// Real-time: yes.
Vector3 base_acceleration(const Gains& gains, const Reference& reference,
                          const Dynamics& dynamics) noexcept;

/// Rows of the base's origin: R (a_lin + w x v_lin) = a, in world axes.
BodyRows base_position_task(const Gains& gains, const Vector3& acceleration,
                            const Dynamics& dynamics) noexcept;

}  // namespace surefoot
