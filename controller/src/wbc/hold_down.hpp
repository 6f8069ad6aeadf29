// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/gains.hpp"
#include "surefoot/math.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Least normal force wanted of each foot [N], FR FL RR RL. Real-time: yes.
///
/// Feet that are pressed down do not slide or lift; but the last newtons of a foot are also the
/// last millimetres of the support. So it fades as the capture point nears the edge.
/// @param fade as edge_fade() has it
Eigen::Vector4d hold_down_forces(const Gains& gains, double weight, double fade,
                                 const Eigen::Vector4d& contact,
                                 const Reference& reference) noexcept;

}  // namespace surefoot
