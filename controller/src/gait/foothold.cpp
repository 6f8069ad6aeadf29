// SPDX-License-Identifier: BSD-3-Clause
#include "gait/foothold.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace surefoot {

Eigen::Vector2d foothold(const HorizontalMotion& motion, const Eigen::Vector2d& nominal_foot,
                         const Eigen::Vector2d& v_command, double yaw_rate, double time_left,
                         double stance_time, double max_offset) noexcept {
  const Eigen::Vector2d p_com = motion.p_com + time_left * motion.v_com;
  const double yaw = motion.yaw + yaw_rate * (time_left + 0.5 * stance_time);
  const Eigen::Vector2d hip = p_com + Eigen::Rotation2Dd(yaw) * nominal_foot;
  Eigen::Vector2d offset =
      0.5 * stance_time * v_command + motion.pendulum_time * (motion.v_com - v_command);
  offset *= std::min(1.0, max_offset / std::max(offset.norm(), 1e-9));
  return hip + offset;
}

}  // namespace surefoot
