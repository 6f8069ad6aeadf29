// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/standing_pose.hpp"

namespace surefoot {

Dynamics standing_dynamics(const Robot& robot) {
  Dynamics standing(robot);
  standing.update(robot.q_standing(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
  return standing;
}

double standing_com_height(const Robot& robot) {
  const Dynamics standing = standing_dynamics(robot);
  return standing.p_world_com().z() - contact_points(standing).row(2).mean();
}

}  // namespace surefoot
