// SPDX-License-Identifier: BSD-3-Clause
#include "safety/holding_torques.hpp"

#include "tasks/even_forces.hpp"

namespace surefoot {

Vector12 holding_torques(const Dynamics& dynamics, double mass, const RobotState& state,
                         const Eigen::Vector4d& share) noexcept {
  const Vector3 force = mass * kGravity * Vector3::UnitZ() - state.f_sustained;
  const Vector12 forces = even_forces(dynamics, force, -state.moment_external, share);
  Vector12 torques;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& leg_dynamics = dynamics.legs()[leg];
    const Vector3 f = forces.segment<3>(3 * leg);
    torques.segment<3>(3 * leg) = leg_dynamics.h_leg;
    if (f.z() > 0.0) torques.segment<3>(3 * leg) -= leg_dynamics.J_leg.transpose() * f;
  }
  return torques;
}

}  // namespace surefoot
