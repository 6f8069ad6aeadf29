// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Body's motion, horizontal, as footholds see it; world axes.
struct HorizontalMotion {
  Eigen::Vector2d p_com, v_com;  ///< [m], [m/s]
  double yaw;                    ///< [rad]
  double pendulum_time;          ///< [s] sqrt(h / g)
};

/// Compute where a foot should land, world x and y [m]: under its hip at mid-stance, plus the
/// distance by which the capture point is ahead of that of the commanded velocity.
/// @param nominal_foot from the centre of mass to the foot in the standing pose, heading axes [m]
/// @param v_command commanded velocity, world axes [m/s]
/// @param yaw_rate commanded [rad/s]
/// @param time_left until touchdown [s]
/// @param max_offset largest distance of the foothold from its hip at touchdown [m]
/// Source: Raibert 1986 (neutral point and velocity feedback); Pratt et al. 2006 (capture point).
/// Real-time: yes.
Eigen::Vector2d foothold(const HorizontalMotion& motion, const Eigen::Vector2d& nominal_foot,
                         const Eigen::Vector2d& v_command, double yaw_rate, double time_left,
                         double stance_time, double max_offset) noexcept;

}  // namespace surefoot
