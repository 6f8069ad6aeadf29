// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// What the tasks of the body want of it, world axes.
struct BodyAcceleration {
  Vector3 a;      ///< [m/s^2] of the reference's body point
  Vector3 alpha;  ///< [rad/s^2] of the base
};

/// Read it from the reference; what of a push is not leant against moves the body, and is no error
/// of the tasks. Real-time: yes.
BodyAcceleration body_acceleration(const Gains& gains, double mass, const Dynamics& dynamics,
                                   const RobotState& state, const Reference& reference) noexcept;

/// Wrench of the feet about the centre of mass, world axes.
struct FeetWrench {
  Vector3 force;   ///< [N]
  Vector3 moment;  ///< [N.m]
};

/// The wrench that makes this motion of the locked robot, which leaves out the legs' own inertia:
///   force = m (a + g up) - f_external,   moment = I alpha + w x I w - moment_external
/// Real-time: yes.
FeetWrench feet_wrench(const BodyAcceleration& desired, double mass, const Dynamics& dynamics,
                       const RobotState& state) noexcept;

}  // namespace surefoot
