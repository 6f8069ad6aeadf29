// SPDX-License-Identifier: BSD-3-Clause
#include "safety/holding_torques.hpp"

#include "tasks/force_task.hpp"

namespace surefoot {

Vector12 holding_torques(const Dynamics& dynamics, double mass, const RobotState& state,
                         const Eigen::Vector4d& share) noexcept {
  const Vector3 force = mass * kGravity * Vector3::UnitZ() - state.f_lasting;
  const Vector12 forces = even_forces(dynamics, force, -state.moment_outside, share);
  Vector12 torques;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& one = dynamics.legs()[leg];
    const Vector3 f = forces.segment<3>(3 * leg);
    torques.segment<3>(3 * leg) = one.h_leg;
    if (f.z() > 0.0) torques.segment<3>(3 * leg) -= one.J_leg.transpose() * f;
  }
  return torques;
}

}  // namespace surefoot
