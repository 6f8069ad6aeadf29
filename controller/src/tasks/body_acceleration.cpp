// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/body_acceleration.hpp"

#include "tasks/base_orientation_task.hpp"
#include "tasks/base_position_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/even_forces.hpp"

namespace surefoot {

BodyAcceleration body_acceleration(const Gains& gains, double mass, const Dynamics& dynamics,
                                   const RobotState& state, const Reference& reference) noexcept {
  const bool base = reference.body_point == BodyPoint::kBase;
  BodyAcceleration desired;
  desired.a = (1.0 - gains.push_resist) / mass * state.f_external;
  desired.a += base ? base_acceleration(gains, reference, dynamics)
                    : com_acceleration(gains, reference, dynamics);
  desired.alpha = base_angular_acceleration(gains, reference, dynamics);
  return desired;
}

FeetWrench feet_wrench(const BodyAcceleration& desired, double mass, const Dynamics& dynamics,
                       const RobotState& state) noexcept {
  return {mass * (desired.a + kGravity * Vector3::UnitZ()) - state.f_external,
          turning_moment(dynamics, desired.alpha) - state.moment_external};
}

}  // namespace surefoot
