// SPDX-License-Identifier: BSD-3-Clause
#include "tasks/body_demand.hpp"

#include "tasks/base_orientation_task.hpp"
#include "tasks/base_position_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/force_task.hpp"

namespace surefoot {

BodyDemand body_demand(const Gains& gains, double mass, const Dynamics& dynamics,
                       const RobotState& state, const Reference& reference) noexcept {
  const bool base = reference.body_point == BodyPoint::kBase;
  BodyDemand demand;
  demand.a = (1.0 - gains.push_resist) / mass * state.f_outside;
  demand.a += base ? base_acceleration(gains, reference, dynamics)
                   : com_acceleration(gains, reference, dynamics);
  demand.alpha = base_angular_acceleration(gains, reference, dynamics);
  return demand;
}

FeetWrench feet_wrench(const BodyDemand& demand, double mass, const Dynamics& dynamics,
                       const RobotState& state) noexcept {
  return {mass * (demand.a + kGravity * Vector3::UnitZ()) - state.f_outside,
          turning_moment(dynamics, demand.alpha) - state.moment_outside};
}

}  // namespace surefoot
