// SPDX-License-Identifier: BSD-3-Clause
// Position mode: the front right leg moves linearly to a pose, then its calf swings.
//   surefoot export go1 go1.robot; surefoot robot --robot go1 --hung &
//   example_position go1.robot --duration 6
#include "low_level_loop.hpp"

using namespace example;

int main(int argc, char** argv) {
  const double pose[] = {0.0, 1.2, -2.0};  // [rad] hip, thigh, calf
  double start[3] = {};
  const auto control = [&](int n, const LowState& state, LowCmd& cmd) {
    for (int k = 0; n < 10 && k < 3; ++k) start[k] = state.motorState[FR_0 + k].q;
    if (n < 10) return;
    const double share = std::min((n - 9) / 200.0, 1.0);  // a step would cause a large torque
    for (int k = 0; k < 3; ++k) {
      MotorCmd& motor = cmd.motorCmd[FR_0 + k];
      motor.q = static_cast<float>(start[k] + share * (pose[k] - start[k]));
      motor.dq = 0.0F;
      motor.Kp = 5.0F;
      motor.Kd = 1.0F;
    }
    if (n >= 400) {  // 0.45 Hz
      const double swing = 0.6 * std::sin(1.8 * M_PI * (n - 400) / 1000.0);
      cmd.motorCmd[FR_2].q = static_cast<float>(pose[2] - swing);
    }
    if (n % 250 == 0) {
      std::printf("%5.1f s  FR_2 %6.3f of %6.3f rad\n", 0.002 * n,
                  static_cast<double>(state.motorState[FR_2].q),
                  static_cast<double>(cmd.motorCmd[FR_2].q));
    }
  };
  return run(argc, argv, control, 11);
}
