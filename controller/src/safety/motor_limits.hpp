// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/robot_config.hpp"

namespace surefoot {

/// Return the torque `tau` [N.m], clamped to `share` (0 .. 1) times the torque that motor `i` can
/// produce at joint velocity `dq` [rad/s]. Real-time: yes.
inline double within_motor_limits(const RobotConfig& config, int i, double tau, double dq,
                                  double share = 1.0) noexcept {
  return std::clamp(tau, -share * motor_torque_limit(config, i, dq, -1.0),
                    share * motor_torque_limit(config, i, dq, 1.0));
}

}  // namespace surefoot
