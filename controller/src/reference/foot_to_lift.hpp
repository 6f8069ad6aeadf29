// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "surefoot/math.hpp"

namespace surefoot {

/// Which foot that bears is to step for a capture point that has left the support; -1: none.
///
/// While a foot is in the air the capture point runs away from what the others span, by e in
/// sqrt(h / g). The foot with which it is furthest inside when it lands is the one, if that is by
/// more than `min_gain`. Two that bear stay, at least. Real-time: yes.
/// Source: Koolen et al. 2012, of the capture point's way in one step.
/// @param p_world_feet (3, 4) contact points, FR FL RR RL [m]
/// @param p_world_goals (3, 4) where each would land [m]
/// @param loaded which of them bear
/// @param capture where the capture point is now, world [m]
/// @param swing from now until it is pressed down [sqrt(h / g)]; it lands a little later
/// @param min_gain by how much it must be inside then [m]
int foot_to_lift(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_goals,
                 const std::array<bool, kLegs>& loaded, const Eigen::Vector2d& capture,
                 double swing, double min_gain) noexcept;

}  // namespace surefoot
