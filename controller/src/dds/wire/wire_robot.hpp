// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/dds_robot.hpp"
#include "surefoot/low_level.hpp"

namespace surefoot {

/// Return the motor mode in which the motors of a robot follow q, dq, tau, kp and kd. Real-time:
/// yes. Source: unitree_sdk2, example/go2/go2_low_level.cpp and example/b2/b2_stand_example.cpp.
constexpr std::uint8_t servo_mode(DdsRobot robot) noexcept {
  return robot == DdsRobot::kGo2 ? 0x01 : 0x0A;
}

/// Return whether the motors of a simulated robot follow a command with this motor mode. For a B2
/// the vendor's C++ example sends 0x0A and its Python example (unitree_sdk2_python,
/// example/b2/low_level/b2_stand_example.py) 0x01. Real-time: yes.
constexpr bool is_servo_command(DdsRobot robot, std::uint8_t mode) noexcept {
  return mode == servo_mode(robot) || mode == 0x01;
}

}  // namespace surefoot
