// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

/// Select the loaded foot that should step when the capture point has left the support polygon.
///
/// While a foot swings, the capture point xi moves away from the nearest point r of the support by
/// the remaining loaded feet: xi(t) = r + exp(t sqrt(g / h)) (xi(0) - r). For each loaded foot, the
/// function predicts the capture margin after this foot has stepped and landed. It selects the foot
/// with the largest margin. At least two loaded feet stay on the ground. Real-time: yes.
/// Source for the capture point during a step: Koolen, de Boer, Rebula, Goswami, Pratt 2012,
/// "Capturability-based analysis and control of legged locomotion, part 1", IJRR.
/// @param p_world_feet contact points, FR FL RR RL, world frame [m]
/// @param p_world_goals landing position of each foot, world frame [m]
/// @param loaded true for each loaded foot
/// @param capture present capture point, world x and y [m]
/// @param swing time from now until the foot is pressed down [sqrt(h / g)]; the foot touches the
///   ground a little later
/// @param min_margin capture margin after landing [m] that a step must exceed
/// @return leg 0 .. 3, or -1 if no foot should step
int foot_to_lift(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_goals,
                 const std::array<bool, kLegs>& loaded, const Eigen::Vector2d& capture,
                 double swing, double min_margin) noexcept;

}  // namespace surefoot
