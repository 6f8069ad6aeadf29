// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pinocchio/multibody.hpp>

#include "surefoot/robot.hpp"

namespace surefoot {

struct Robot::Data {
  pinocchio::Model model;
  RobotConfig config;
  std::array<int, kMotors> motor_to_v;
  std::array<int, kMotors> motor_to_q;
  std::array<int, kLegs> foot_frame_ids;
  double mass;
};

}  // namespace surefoot
