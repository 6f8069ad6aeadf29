// SPDX-License-Identifier: BSD-3-Clause
#include "gait/trot_load.hpp"

#include <cmath>

#include "dynamics/standing_pose.hpp"

namespace surefoot {

TrotLoad trot_load(const Robot& robot) {
  const Dynamics standing = standing_dynamics(robot);
  const Vector3 force = 0.5 * robot.mass() * kGravity * Vector3::UnitZ();
  TrotLoad largest;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& dynamics = standing.legs()[leg];
    const Vector3 tau = dynamics.h_leg - dynamics.J_leg.transpose() * force;
    for (int k = 0; k < kLegJoints; ++k) {
      const int motor = kLegJoints * leg + k;
      const double share = std::abs(tau[k]) / robot.config().tau_max[motor];
      if (share > largest.share) largest = {share, motor};
    }
  }
  return largest;
}

}  // namespace surefoot
