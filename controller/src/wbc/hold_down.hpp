// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Compute the hold-down of each foot, which is the smallest normal force that the QP should keep
/// on it:
///   hold_down * weight * fade * planned load * contact confidence   [N], FR FL RR RL
/// While one foot of a stepping robot swings, it is walk_hold_down.
///
/// Hold-down is an elastic constraint. Hold-down keeps feet from sliding and lifting. But with a
/// minimum force on every foot, the centre of pressure cannot reach the support edge, and the QP
/// cannot brake as hard as possible. So the hold-down fades to zero as the capture point approaches
/// the edge. Real-time: yes.
/// @param weight weight of the robot [N]
/// @param fade result of edge_fade(), 0 .. 1
/// @param contact contact confidence of each foot, 0 .. 1, FR FL RR RL
Eigen::Vector4d hold_down_forces(const Gains& gains, double weight, double fade,
                                 const Eigen::Vector4d& contact,
                                 const Reference& reference) noexcept;

}  // namespace surefoot
