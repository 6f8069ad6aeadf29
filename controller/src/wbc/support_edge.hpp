// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"
#include "tasks/body_acceleration.hpp"

namespace surefoot {

// Near the support edge, braking the body has priority over hold-down, height and tilt. edge_fade()
// measures how near the capture point is to the edge. As edge_fade() falls from 1 to 0:
//   hold-down fades out (hold_down.hpp);
//   height and tilt tasks lose weight, down to the gains edge_height and edge_tilt;
//   the desired body acceleration is bounded, so that the feet keep load (bound_at_edge());
//   legs with unloaded feet are released (released_legs.hpp).
// edge_braking_axes.hpp does not depend on edge_fade(): near an edge, braking across the edge
// always has priority over braking along it.

/// Compute the edge fade, 0 .. 1: clamp(margin / edge_margin, 0, 1). Here `margin` [m] is the
/// distance of the capture point inside the support polygon. With fewer than three stance feet the
/// edge fade is 1.
/// Real-time: yes.
double edge_fade(const Gains& gains, const Dynamics& dynamics, const Reference& reference) noexcept;

/// Bound the desired acceleration of the body, so that the feet keep force to brake a push:
///   a_z >= (edge_load - 1 - 0.35 fade) g
///   |alpha_xy| <= slow (1 + 30 fade^2) g / length
///   slow = clamp(1.6 (1 - v_up / edge_rise), 0, 1)
///
/// Height: hard braking throws the body up. If the body then falls freely, the feet carry no load
/// and cannot brake. So the bound keeps a total load of at least edge_load on the feet. Away from
/// the edge the bound is only a little lower: a body that starts to fall while its capture point is
/// inside is still falling when the capture point reaches the edge.
/// Tilt: braking also tilts the body. To turn the body back at once, the feet would need the force
/// that brakes the push. So the body turns back slowly until the capture point is inside again. The
/// forces that turn the body back also push the body up, so a body that already rises fast turns
/// back less, or not at all.
/// Real-time: yes.
/// @param fade result of edge_fade(), 0 .. 1
/// @param length [m] QpUnits::length, the height of the hips above the ground in the standing pose
/// @param v_up [m/s] vertical velocity of the centre of mass
/// @param desired in and out: acceleration of the body, world axes
void bound_at_edge(const Gains& gains, double fade, double length, double v_up,
                   BodyAcceleration& desired) noexcept;

}  // namespace surefoot
