// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/support_polygon.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Where the robot would have to step to come to rest, p_com + v_com / omega on the ground [m],
/// world. Real-time: yes.
/// @param dv_com [m/s] velocity of the centre of mass besides the one it has, world
/// Source: Pratt et al. 2006, eq. 4.
Eigen::Vector2d capture_point(const Dynamics& dynamics,
                              const Vector3& dv_com = Vector3::Zero()) noexcept;

/// The polygon of the feet that a reference stands on. Real-time: yes.
SupportPolygon support_polygon(const Dynamics& dynamics, const Reference& reference) noexcept;

/// Distance of the capture point inside the support polygon's nearest edge [m]; negative outside,
/// infinite with fewer than three stance feet: no edge to be near. Real-time: yes.
double capture_margin(const Dynamics& dynamics, const std::array<bool, kLegs>& stance,
                      const Vector3& dv_com = Vector3::Zero()) noexcept;
/// @param dv_com [m/s] velocity of the centre of mass besides the one it has, world
double capture_margin(const Dynamics& dynamics, const Reference& reference,
                      const Vector3& dv_com = Vector3::Zero()) noexcept;

}  // namespace surefoot
