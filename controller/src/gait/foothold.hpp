// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"

namespace surefoot {

/// Compute where a foot should land, world x and y [m]. Real-time: yes.
///
/// The foothold is the sum of
///  - the place of the hip at touchdown,
///  - the mean displacement of the body over the stance,
///  - the mean offset of the zero-moment point from the centre of mass, which is opposite to the
///    planned acceleration,
///  - foothold_feedback times sqrt(h/g) times the difference between measured and planned velocity,
///    which brakes a push.
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

/// Move a foothold outwards if the left and the right leg would touch. Real-time: yes.
/// @param yaw heading of the body [rad]
/// @param across place of the other front foot, or of the other rear foot, world x and y [m]
Eigen::Vector2d keep_apart(const GaitSize& size, double yaw, int leg,
                           const Eigen::Vector2d& foothold, const Eigen::Vector2d& across) noexcept;

}  // namespace surefoot
