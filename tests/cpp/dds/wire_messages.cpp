// SPDX-License-Identifier: BSD-3-Clause
#include "wire_messages.hpp"

#include <cstring>

#include "surefoot/low_level.hpp"

namespace surefoot {

namespace {

DdsLowCmd command_with_header() {
  DdsLowCmd cmd;
  std::memset(&cmd, 0, sizeof(cmd));
  cmd.head[0] = 0xFE;
  cmd.head[1] = 0xEF;
  cmd.level_flag = LOWLEVEL;
  return cmd;
}

}  // namespace

DdsLowCmd vendor_init_command(std::uint8_t mode) {
  DdsLowCmd cmd = command_with_header();
  for (DdsMotorCmd& motor : cmd.motor_cmd) {
    motor.mode = mode;
    motor.q = static_cast<float>(PosStopF);
    motor.dq = static_cast<float>(VelStopF);
  }
  return cmd;
}

DdsLowCmd vendor_torque_command() {
  DdsLowCmd cmd = vendor_init_command(1);
  for (int i = 0; i < kMotors; ++i) {
    cmd.motor_cmd[i].tau = 0.5F * static_cast<float>(i + 1) * (i % 2 == 0 ? 1.0F : -1.0F);
  }
  return cmd;
}

DdsLowCmd every_field_command() {
  DdsLowCmd cmd = command_with_header();
  cmd.frame_reserve = 5;
  cmd.sn[0] = 1, cmd.sn[1] = 2;
  cmd.version[0] = 3, cmd.version[1] = 4;
  cmd.bandwidth = 0x0102;
  for (int i = 0; i < kMotorSlots; ++i) {
    DdsMotorCmd& motor = cmd.motor_cmd[i];
    const auto number = static_cast<std::uint32_t>(i);
    motor.mode = static_cast<std::uint8_t>(i);
    motor.q = static_cast<float>(0.1 * i);
    motor.dq = static_cast<float>(-0.2 * i);
    motor.tau = static_cast<float>(0.3 * i);
    motor.kp = static_cast<float>(10 + i);
    motor.kd = static_cast<float>(0.5 * i);
    for (std::uint32_t k = 0; k < 3; ++k) motor.reserve[k] = number + k;
  }
  cmd.bms_cmd.off = 0xA5;
  for (std::uint8_t k = 0; k < 40; ++k) cmd.wireless_remote[k] = k;
  for (std::uint8_t k = 0; k < 12; ++k) cmd.led[k] = k;
  cmd.fan[0] = 7, cmd.fan[1] = 8;
  cmd.gpio = 1;
  cmd.reserve = 0x12345678;
  return cmd;
}

}  // namespace surefoot
