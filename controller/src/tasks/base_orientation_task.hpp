// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Angular acceleration that turns the base to its reference, world axes [rad/s^2]:
///   alpha = alpha_ref + kp log(R_ref R') + kd (w_ref - w)
/// with one stiffness about the horizontal axes and another about the vertical. Real-time: yes.
Vector3 base_angular_acceleration(const Gains& gains, const Reference& reference,
                                  const Dynamics& dynamics) noexcept;

/// Rows of the base's orientation, in world axes like its gains: R a_ang = alpha.
BodyRows base_orientation_task(const Gains& gains, const Vector3& angular_acceleration_world,
                               const Dynamics& dynamics) noexcept;

}  // namespace surefoot
