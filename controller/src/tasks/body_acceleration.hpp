// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tasks/body_rows.hpp"

namespace surefoot {

/// Desired acceleration of the body, world axes.
struct BodyAcceleration {
  Vector3 a;      ///< [m/s^2] acceleration of the reference's body point
  Vector3 alpha;  ///< [rad/s^2] angular acceleration of the base
};

/// Compute the desired acceleration from reference and state:
///   a = (1 - push_resist) f_external / m + a_task,   alpha = alpha_task
/// The feet resist the share push_resist of the external force. The rest of the force accelerates
/// the body. This acceleration counts as desired, so it is no task error. Real-time: yes.
BodyAcceleration body_acceleration(const Gains& gains, double mass, const Dynamics& dynamics,
                                   const RobotState& state, const Reference& reference) noexcept;

/// Sum of the contact forces, and their moment about the centre of mass, world axes.
struct FeetWrench {
  Vector3 force;   ///< [N]
  Vector3 moment;  ///< [N.m]
};

/// Compute the contact wrench that gives a robot with locked joints the acceleration `desired`:
///   force = m (a + g up) - f_external,   moment = I alpha + w x I w - moment_external
/// The motion of the legs relative to the base is neglected. Real-time: yes.
FeetWrench feet_wrench(const BodyAcceleration& desired, double mass, const Dynamics& dynamics,
                       const RobotState& state) noexcept;

}  // namespace surefoot
