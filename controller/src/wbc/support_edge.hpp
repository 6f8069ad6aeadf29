// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"
#include "tasks/body_acceleration.hpp"

namespace surefoot {

/// 1 while the capture point is at least edge_margin inside the support, 0 at its edge.
/// Real-time: yes.
double edge_fade(const Gains& gains, const Dynamics& dynamics, const Reference& reference) noexcept;

/// Keep what is asked of the body within what leaves the feet something to brake with at the
/// support's edge. Real-time: yes.
///
/// Legs that brake a push with all they have throw the body up, and if it then falls freely nothing
/// brakes: the feet keep edge_load, and little less away from the edge, for a body that was asked
/// to fall there is still falling as it comes near. They tilt it as well, and turning it back at
/// once takes the very force that brakes, or more: it comes back slowly until the body is inside
/// again. The feet that turn it back also throw it further up: not while it rises fast.
/// @param fade as edge_fade() has it
/// @param length [m] hips over the ground: angles are asked back by g / length at most
/// @param v_up [m/s] of the centre of mass: a body that rises is asked back less, see edge_rise
void bound_at_edge(const Gains& gains, double fade, double length, double v_up,
                   BodyAcceleration& desired) noexcept;

}  // namespace surefoot
