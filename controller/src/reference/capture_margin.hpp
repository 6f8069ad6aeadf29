// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/support_polygon.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Compute the capture point of the linear inverted pendulum, p_com + v_com / omega with
/// omega = sqrt(g / h): the ground point over which the robot would come to rest [m], world x and
/// y. Real-time: yes.
/// @param dv_com [m/s] added to the velocity of the centre of mass, world axes
/// Source: Pratt, Carff, Drakunov, Goswami 2006, "Capture point: a step toward humanoid push
/// recovery", eq. 4.
Eigen::Vector2d capture_point(const Dynamics& dynamics,
                              const Vector3& dv_com = Vector3::Zero()) noexcept;

/// Return the support polygon: stance feet of the reference with a planned load above zero.
/// Real-time: yes.
SupportPolygon support_polygon(const Dynamics& dynamics, const Reference& reference) noexcept;

/// Compute the distance [m] from the capture point to the nearest edge of the support polygon:
/// positive inside, negative outside, infinite with fewer than three stance feet. Real-time: yes.
/// @param dv_com [m/s] added to the velocity of the centre of mass, world axes
double capture_margin(const Dynamics& dynamics, const std::array<bool, kLegs>& stance,
                      const Vector3& dv_com = Vector3::Zero()) noexcept;
/// The same, with the stance feet of a reference.
double capture_margin(const Dynamics& dynamics, const Reference& reference,
                      const Vector3& dv_com = Vector3::Zero()) noexcept;

}  // namespace surefoot
