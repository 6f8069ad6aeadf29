// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"

namespace surefoot {

/// Largest ratio of torque to torque limit when two diagonal feet carry the robot.
struct TrotLoad {
  double share = 0.0;  ///< torque / torque limit of the motor
  int motor = 0;       ///< SDK number of the motor
};

/// TrotLoad::share above which a robot cannot walk. Chosen: the rest is for acceleration and
/// pushes. Unitree's robots have 0.15 .. 0.5.
constexpr double kMaxTrotLoad = 0.8;

/// Return the largest of these ratios in the standing pose, with half of the weight on each foot.
/// Real-time: no.
TrotLoad trot_load(const Robot& robot);

}  // namespace surefoot
