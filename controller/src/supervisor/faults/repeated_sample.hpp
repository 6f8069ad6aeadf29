// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detects samples whose gyroscope, accelerometer and joint values repeat while the tick advances.
/// Then the link works, but the sensor board has stopped. Real-time: yes.
class RepeatedSample {
 public:
  /// [s] Time for which values may repeat before they are too old. Derived: after this time the
  /// last good command is repeated for kHoldTime = 10 ms. The sum, 20 ms, must exceed the 18 ms for
  /// which a robot that measures at 50 Hz repeats its values at 500 Hz.
  static constexpr double kMaxAge = 0.010;

  /// Compare a sample with the previous sample. @param step [s] time between the two samples
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
  /// Return whether the values of the last sample are too old to act upon. The 1e-9 s allow for
  /// rounding.
  bool too_old() const noexcept { return repeat_time_ >= kMaxAge - 1e-9; }
  /// Return whether the sensors have stopped: the values have repeated for longer than those of a
  /// robot that measures at 50 Hz, the lowest measurement rate of all robots.
  bool stopped() const noexcept { return repeat_time_ >= kStoppedTime; }
  /// Return whether the last sample had the same values as the sample before it.
  bool repeats() const noexcept { return repeat_time_ > 0.0; }

 private:
  static constexpr double kStoppedTime =
      0.022;  // [s] derived: one period at 50 Hz plus one at 500 Hz
  using Values = Eigen::Matrix<float, 42, 1>;
  Values last_values_ = Values::Constant(NAN);
  double repeat_time_ = 0.0;  // [s] time for which the values have repeated
};

}  // namespace surefoot
