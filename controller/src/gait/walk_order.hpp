// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "gait/gait_size.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Legs in the order in which they lift off, one at a time.
using WalkOrder = std::array<int, kLegs>;

/// Return a measure [m^2] of the sway that a steady walk needs: the sum, over the four swings, of
/// the squared distance from the centre of mass to the support triangle of the other feet, shrunk
/// by a margin. Real-time: yes.
/// @param period of the gait [s]
/// @param margin distance of the zero-moment point from the support edges [m]
double sway_of(const WalkOrder& order, const GaitSize& size, const WalkVelocity& velocity,
               double period, double margin) noexcept;

/// Return the order that needs the least sway. `present` is kept unless another order needs
/// clearly less, because a change of the order takes time. Real-time: yes.
///
/// Forwards this is RR FR RL FL, the lateral sequence of walking animals: a foot is far behind
/// when it lifts off, so the triangle of the others contains the body. Source: McGhee, Frank 1968,
/// On the stability properties of quadruped creeping gaits.
WalkOrder best_walk_order(const WalkOrder& present, const GaitSize& size,
                          const WalkVelocity& velocity, double period, double margin) noexcept;

}  // namespace surefoot
