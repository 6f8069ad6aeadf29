// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/low_level.hpp"

namespace surefoot {

LowCmd init_low_cmd() noexcept {
  LowCmd cmd{};
  cmd.head = {0xFE, 0xEF};
  cmd.levelFlag = LOWLEVEL;
  for (MotorCmd& motor : cmd.motorCmd) {
    motor.mode = kModeServo;
    motor.q = static_cast<float>(PosStopF);
    motor.dq = static_cast<float>(VelStopF);
  }
  return cmd;
}

LowState init_low_state() noexcept {
  LowState state{};
  state.head = {0xFE, 0xEF};
  state.levelFlag = LOWLEVEL;
  return state;
}

LowCmd damping_low_cmd(double kd) noexcept {
  LowCmd cmd = init_low_cmd();
  for (int i = 0; i < kMotors; ++i) {
    cmd.motorCmd[i].dq = 0.0F;
    cmd.motorCmd[i].Kd = static_cast<float>(kd);
  }
  return cmd;
}

}  // namespace surefoot
