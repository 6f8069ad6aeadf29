// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Notices reports whose sensors repeat those before while the tick goes on: a sensor board that
/// hangs behind a link that lives. Real-time: yes.
class RepeatedReport {
 public:
  /// [s] that may repeat: robots that measure at 50 Hz do so for 18 ms, and the last good command
  /// may live on for 10 of them.
  static constexpr double kPatience = 0.010;

  /// @param step [s] since the report before
  void update(const LowState& state, double step) noexcept {
    Words words;
    const IMU& imu = state.imu;
    words << imu.gyroscope[0], imu.gyroscope[1], imu.gyroscope[2], imu.accelerometer[0],
        imu.accelerometer[1], imu.accelerometer[2], Eigen::Matrix<float, 36, 1>::Zero();
    for (int i = 0; i < kMotors; ++i) {
      const MotorState& motor = state.motorState[i];
      words.segment<3>(6 + 3 * i) << motor.q, motor.dq, motor.tauEst;
    }
    same_for_ = words == words_ ? same_for_ + step : 0.0;
    words_ = words;
  }
  /// Is what the last report says too old to be acted upon?
  bool too_old() const noexcept { return same_for_ >= kPatience - 1e-9; }
  /// Have the sensors stopped? No robot measures at less than 50 Hz.
  bool stopped() const noexcept { return same_for_ >= kStopped; }
  /// Was the last report the same as the one before it?
  bool repeats() const noexcept { return same_for_ > 0.0; }

 private:
  static constexpr double kStopped = 0.022;  // [s]
  using Words = Eigen::Matrix<float, 42, 1>;
  Words words_ = Words::Constant(NAN);
  double same_for_ = 0.0;  // [s]
};

}  // namespace surefoot
