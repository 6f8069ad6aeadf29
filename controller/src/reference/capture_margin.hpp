// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Distance of the capture point, p_com + v_com / omega on the ground, inside the support polygon's
/// nearest edge [m]; negative outside, infinite with fewer than three stance feet: no edge to
/// be near. Real-time: yes.
/// Source: Pratt et al. 2006, eq. 4.
double capture_margin(const Dynamics& dynamics, const std::array<bool, kLegs>& stance,
                      const Vector3& gained = Vector3::Zero()) noexcept;
/// @param gained [m/s] velocity of the centre of mass besides the one it has, world
double capture_margin(const Dynamics& dynamics, const Reference& reference,
                      const Vector3& gained = Vector3::Zero()) noexcept;

}  // namespace surefoot
