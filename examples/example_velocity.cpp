// SPDX-License-Identifier: BSD-3-Clause
// Velocity mode: the front right thigh follows a sine of 2 rad/s at 0.5 Hz.
#include "low_level_loop.hpp"

using namespace example;

int main(int argc, char** argv) {
  const auto control = [](int n, const LowState& state, LowCmd& cmd) {
    if (n < 500) return;
    const double speed = 2.0 * std::sin(3.0 * M_PI * (n - 500) / 1500.0);
    MotorCmd& motor = cmd.motorCmd[FR_1];
    motor.q = static_cast<float>(PosStopF);
    motor.dq = static_cast<float>(speed);
    motor.Kp = 0.0F;
    motor.Kd = 4.0F;
    motor.tau = 0.0F;
    if (n % 250 == 0) {
      std::printf("%5.1f s  FR_1 %6.3f of %6.3f rad/s\n", 0.002 * n,
                  static_cast<double>(state.motorState[FR_1].dq), speed);
    }
  };
  return run(argc, argv, control, 11);
}
