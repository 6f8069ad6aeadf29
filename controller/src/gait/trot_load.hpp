// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot.hpp"

namespace surefoot {

/// Largest torque that carries the robot on two diagonal feet.
struct TrotLoad {
  double share = 0.0;  ///< torque / torque limit of the motor
  int motor = 0;       ///< SDK number of the motor
};

/// TrotLoad::share above which a robot cannot walk. Chosen: the rest is for acceleration and
/// pushes. Unitree's robots have 0.15 .. 0.5.
constexpr double kMaxTrotLoad = 0.8;

/// Compute the load of each motor if its foot carries half of the weight in the standing pose, and
/// return the largest. Real-time: no.
TrotLoad trot_load(const Robot& robot);

}  // namespace surefoot
