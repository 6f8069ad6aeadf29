// SPDX-License-Identifier: BSD-3-Clause
#include "gait/gait_size.hpp"

#include <cmath>

#include "dynamics/standing_pose.hpp"

namespace surefoot {

GaitSize::GaitSize(const Robot& robot) {
  const Dynamics standing = standing_dynamics(robot);
  nominal_feet = contact_points(standing).colwise() - standing.p_world_com();
  nominal_base = standing.p_world_base() - standing.p_world_com();
  height = -nominal_feet.row(2).mean();
  corner_speed = robot.config().corner_speed[1];
  time = std::sqrt(height / kGravity);
  speed = std::sqrt(kGravity * height);
}

double GaitSize::fastest_hip(const WalkVelocity& velocity) const noexcept {
  const double arm = nominal_feet.topRows<2>().colwise().norm().maxCoeff();
  return std::hypot(velocity.vx, velocity.vy) + arm * std::abs(velocity.yaw_rate);
}

}  // namespace surefoot
