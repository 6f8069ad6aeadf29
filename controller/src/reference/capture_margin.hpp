// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/support_polygon.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Compute the capture point of the linear inverted pendulum: world x and y [m] of the ground point
/// over which the robot would come to rest,
///   p_com + v_com / omega,   omega = sqrt(g / h),
/// where h is the height of the centre of mass above the mean height of the feet. Real-time: yes.
/// @param dv_com velocity added to that of the centre of mass, world axes [m/s]
/// Source: Pratt, Carff, Drakunov, Goswami 2006, "Capture point: a step toward humanoid push
/// recovery", eq. 4.
Eigen::Vector2d capture_point(const Dynamics& dynamics,
                              const Vector3& dv_com = Vector3::Zero()) noexcept;

/// Return the polygon of all feet that are stance feet in `reference` with a planned load above 0.
/// Real-time: yes.
SupportPolygon support_polygon(const Dynamics& dynamics, const Reference& reference) noexcept;

/// Compute the capture margin [m], the signed distance from the capture point to the nearest edge
/// line of the support polygon. Positive: inside. Negative: outside. +inf: fewer than three stance
/// feet. Real-time: yes.
/// @param stance true for each foot that is a corner of the support polygon
/// @param dv_com velocity added to that of the centre of mass, world axes [m/s]
double capture_margin(const Dynamics& dynamics, const std::array<bool, kLegs>& stance,
                      const Vector3& dv_com = Vector3::Zero()) noexcept;
/// Compute the capture margin [m] for the feet of support_polygon().
double capture_margin(const Dynamics& dynamics, const Reference& reference,
                      const Vector3& dv_com = Vector3::Zero()) noexcept;

}  // namespace surefoot
