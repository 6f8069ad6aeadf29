// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Notices reports whose sensors repeat those before while the tick goes on: a sensor board that
/// hangs behind a link that lives. Real-time: yes.
class RepeatedSample {
 public:
  /// [s] that may repeat: robots that measure at 50 Hz do so for 18 ms, and the last good command
  /// may live on for 10 of them.
  static constexpr double kMaxAge = 0.010;

  /// @param step [s] since the report before
  void update(const LowState& state, double step) noexcept {
    Values values;
    const IMU& imu = state.imu;
    values << imu.gyroscope[0], imu.gyroscope[1], imu.gyroscope[2], imu.accelerometer[0],
        imu.accelerometer[1], imu.accelerometer[2], Eigen::Matrix<float, 36, 1>::Zero();
    for (int i = 0; i < kMotors; ++i) {
      const MotorState& motor = state.motorState[i];
      values.segment<3>(6 + 3 * i) << motor.q, motor.dq, motor.tauEst;
    }
    repeat_time_ = values == last_values_ ? repeat_time_ + step : 0.0;
    last_values_ = values;
  }
  /// Is what the last report says too old to be acted upon?
  bool too_old() const noexcept { return repeat_time_ >= kMaxAge - 1e-9; }
  /// Have the sensors stopped? No robot measures at less than 50 Hz.
  bool stopped() const noexcept { return repeat_time_ >= kStopped; }
  /// Was the last report the same as the one before it?
  bool repeats() const noexcept { return repeat_time_ > 0.0; }

 private:
  static constexpr double kStopped = 0.022;  // [s]
  using Values = Eigen::Matrix<float, 42, 1>;
  Values last_values_ = Values::Constant(NAN);
  double repeat_time_ = 0.0;  // [s]
};

}  // namespace surefoot
