// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

/// Select the loaded foot that should step when the capture point has left the support polygon.
///
/// While a foot swings, the capture point xi moves away from the nearest point r of the remaining
/// support: xi(t) = r + exp(t sqrt(g / h)) (xi(0) - r). The function selects the foot after whose
/// landing the capture margin is largest. At least two loaded feet stay on the ground. Real-time:
/// yes.
/// Source: Koolen, de Boer, Rebula, Goswami, Pratt 2012, "Capturability-based analysis and control
/// of legged locomotion, part 1", IJRR, for the capture point during a step.
/// @param p_world_feet contact points, shape (3, 4), FR FL RR RL [m]
/// @param p_world_goals landing position of each foot, shape (3, 4) [m]
/// @param loaded which feet are loaded
/// @param capture present capture point, world [m]
/// @param swing duration until the foot is pressed down [sqrt(h / g)]; it lands a little later
/// @param min_margin capture margin after landing that a step must exceed [m]
/// @return leg, or -1 if no foot should step
int foot_to_lift(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_goals,
                 const std::array<bool, kLegs>& loaded, const Eigen::Vector2d& capture,
                 double swing, double min_margin) noexcept;

}  // namespace surefoot
