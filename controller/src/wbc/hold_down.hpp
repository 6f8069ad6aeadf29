// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// 1 while the capture point is at least edge_margin inside the support, 0 at its edge.
double edge_fade(const Gains& gains, const Dynamics& dynamics, const Reference& reference) noexcept;

/// Least vertical acceleration [m/s^2] that is asked of the body. Real-time: yes.
///
/// Legs that brake a push with all they have throw the body up, and if it then falls freely nothing
/// brakes: at the support's edge the feet keep edge_load, away from it anything may be asked.
double least_lift(const Gains& gains, double fade) noexcept;

/// Least normal force wanted of each foot [N], FR FL RR RL. Real-time: yes.
///
/// Feet that are pressed down do not slide or lift; but the last newtons of a foot are also the
/// last millimetres of the support. So it fades as the capture point nears the edge.
/// @param fade as edge_fade() has it
Eigen::Vector4d hold_down_forces(const Gains& gains, double weight, double fade,
                                 const Eigen::Vector4d& contact,
                                 const Reference& reference) noexcept;

}  // namespace surefoot
