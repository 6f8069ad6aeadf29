// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the desired acceleration of the centre of mass, world axes [m/s^2]:
///   a = a_ref + kp (p_ref - p) + kd (v_ref - v)
/// Real-time: yes.
Vector3 com_acceleration(const Gains& gains, const Reference& reference,
                         const Dynamics& dynamics) noexcept;

/// Compute the rows of the centre of mass task: (sum f_i + f_external) / m - g up = a, world axes.
/// The rows are exact for any motion of the joints. Real-time: yes.
BodyRows com_task(const Gains& gains, const Vector3& acceleration, const Vector3& f_external,
                  double mass) noexcept;

}  // namespace surefoot
