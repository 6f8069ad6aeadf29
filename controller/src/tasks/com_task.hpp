// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Acceleration that pulls the centre of mass to its reference, world axes [m/s^2]:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v)
/// Real-time: yes.
Vector3 com_acceleration(const Gains& gains, const Reference& reference,
                         const Dynamics& dynamics) noexcept;

/// Rows of the centre of mass: (sum(f) + f_external) / m + g = a, exact for any motion of the
/// joints.
BodyRows com_task(const Gains& gains, const Vector3& acceleration, const Vector3& f_external,
                  double mass) noexcept;

}  // namespace surefoot
