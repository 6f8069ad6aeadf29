// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Compute the desired angular acceleration of the base, world axes [rad/s^2]:
///   alpha = alpha_ref + kp log(R_ref R') + kd (w_ref - w)
/// The horizontal axes (tilt) and the vertical axis (yaw) have separate gains. Real-time: yes.
Vector3 base_angular_acceleration(const Gains& gains, const Reference& reference,
                                  const Dynamics& dynamics) noexcept;

/// Compute the rows of the orientation task, R a_ang = alpha, world axes. Real-time: yes.
/// @param stepping selects the weights: gain walk_weight_base_rotation for all axes if true, else
///   weight_base_tilt and weight_base_yaw
BodyRows base_orientation_task(const Gains& gains, const Vector3& angular_acceleration_world,
                               const Dynamics& dynamics, bool stepping) noexcept;

}  // namespace surefoot
