// SPDX-License-Identifier: BSD-3-Clause
// Torque mode: hold the front right thigh at zero with a torque of at most 5 N.m.
#include "low_level_loop.hpp"

using namespace example;

int main(int argc, char** argv) {
  const auto control = [](int n, const LowState& state, LowCmd& cmd) {
    if (n < 500) return;
    const MotorState thigh = state.motorState[FR_1];
    const float torque = (0.0F - thigh.q) * 10.0F + (0.0F - thigh.dq) * 1.0F;
    MotorCmd& motor = cmd.motorCmd[FR_1];
    motor.q = static_cast<float>(PosStopF);
    motor.dq = static_cast<float>(VelStopF);
    motor.Kp = 0.0F;
    motor.Kd = 0.0F;
    motor.tau = std::min(std::max(torque, -5.0F), 5.0F);
    if (n % 250 == 0) {
      std::printf("%5.1f s  FR_1 %6.3f rad, %5.2f N.m\n", 0.002 * n, static_cast<double>(thigh.q),
                  static_cast<double>(motor.tau));
    }
  };
  return run(argc, argv, control, 1);
}
