// SPDX-License-Identifier: BSD-3-Clause
#include "low_state_check.hpp"

#include <cmath>

namespace surefoot {

namespace {

// Beyond anything a sensor of these robots can say, in any of the units; false for NaN.
bool credible(float value) noexcept { return std::abs(value) <= 1e4F; }

bool credible(const IMU& imu) noexcept {
  // Packed fields are not aligned: copy them before indexing.
  const std::array<float, 4> quaternion = imu.quaternion;
  const std::array<float, 3> gyroscope = imu.gyroscope, accelerometer = imu.accelerometer;
  bool good = true;
  for (int i = 0; i < 4; ++i) good = good && credible(quaternion[i]);
  for (int i = 0; i < 3; ++i) good = good && credible(gyroscope[i]) && credible(accelerometer[i]);
  return good;
}

}  // namespace

bool finite(const LowState& state) noexcept {
  bool good = credible(state.imu);
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = state.motorState[i];
    good = good && credible(motor.q) && credible(motor.dq) && credible(motor.tauEst);
  }
  return good;
}

}  // namespace surefoot
