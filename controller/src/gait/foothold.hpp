// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"

namespace surefoot {

/// Compute where a foot should land, world x and y [m]. Real-time: yes.
///
/// The foot is under its hip in the mean of its stance, shifted by the mean distance of the
/// zero-moment point from the centre of mass: against the acceleration of the trajectory, for the
/// part of the stance in which it lasts. To this a distance is added in proportion to the velocity
/// beyond that of the trajectory (gain foothold_feedback), so that the step brakes what a push has
/// added.
/// @param time_left until touchdown [s]
/// @param stance_time above 0 [s]
/// Sources: Raibert 1986, "Legged robots that balance"; Pratt et al. 2006 (capture point).
Eigen::Vector2d foothold(const Gains& gains, const GaitSize& size, const HorizontalMotion& measured,
                         const BodyTrajectory& body, int leg, double time_left,
                         double stance_time) noexcept;

/// Limit the change of a foothold while its foot swings, so that the foot can still reach it.
/// Real-time: yes.
/// @param last foothold of the tick before, world x and y [m]
/// @param time_left until touchdown [s]
Eigen::Vector2d within_reach(const Eigen::Vector2d& last, const Eigen::Vector2d& foothold,
                             double time_left, double dt) noexcept;

/// Move a foothold to the side of its leg if the left and the right leg would touch. Real-time:
/// yes.
/// @param yaw heading of the body [rad]
/// @param across place of the other front foot, or of the other rear foot, world x and y [m]
Eigen::Vector2d keep_apart(const GaitSize& size, double yaw, int leg,
                           const Eigen::Vector2d& foothold, const Eigen::Vector2d& across) noexcept;

}  // namespace surefoot
