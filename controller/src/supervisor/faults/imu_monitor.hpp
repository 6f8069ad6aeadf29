// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/debounce.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Compares the IMU's attitude with its gyroscope, in every mode.
///
/// The gyroscope propagates the last accepted attitude. An attitude that jumps away from the
/// propagated one is not plausible; after 0.5 s of such attitudes, a new one is accepted. A
/// gyroscope that drifts shows in the mean difference between its rate and the rate of the
/// attitude. A sensor that has stopped shows in values that repeat or clip. Real-time: yes.
class ImuMonitor {
 public:
  /// Judge the IMU of a sample.
  /// @param step [s] since the last update
  /// @param changed whether any IMU or joint value differs from the previous sample
  /// @param may_turn_fast whether the body may turn fast for longer than a push lasts; the
  /// tolerance then covers an error of the gyroscope's scale
  void update(const IMU& imu, double step, bool changed, bool may_turn_fast) noexcept;
  /// Return whether the rates of the last sample are usable. Not usable: they changed more since
  /// the previous sample than those of a body can.
  bool rates_plausible() const noexcept { return rates_plausible_; }
  /// Return whether the attitude of the last sample is usable. Not usable: its length is not 1, or
  /// it jumped away from the integrated gyroscope.
  bool attitude_plausible() const noexcept { return attitude_plausible_; }
  /// Return whether for 50 ms the gyroscope has repeated its values, clipped, or disagreed with the
  /// attitude.
  bool gyroscope_bad() const noexcept { return gyroscope_bad_; }
  /// Return whether the accelerometer has repeated its values for 50 ms.
  bool accelerometer_bad() const noexcept { return accelerometer_bad_; }

 private:
  void judge_rates(const Vector3& w, double step, bool changed, double max_error) noexcept;
  void judge_accelerometer(const Vector3& a, double step, bool changed) noexcept;
  bool is_consistent(const Quaternion& attitude, const Vector3& w) const noexcept;

  Quaternion R_ = Quaternion::Identity();              // IMU to world, propagated by the gyroscope
  Quaternion last_attitude_ = Quaternion::Identity();  // IMU to world, last measured
  Vector3 w_last_ = Vector3::Zero();                   // [rad/s] gyroscope of the last sample
  Vector3 rate_error_ = Vector3::Zero();  // [rad/s] mean of gyroscope minus rate of the attitude
  double mean_rate_ = 0.0;                // [rad/s] mean magnitude of the gyroscope
  double rejected_time_ = 0.0;            // [s] since the last accepted attitude
  bool started_ = false, gyroscope_bad_ = false, rates_plausible_ = true,
       attitude_plausible_ = true;
  Vector3 a_last_ = Vector3::Zero();  // [m/s^2] accelerometer of the last sample
  bool accelerometer_bad_ = false;
  Debounce gyroscope_held_, gyroscope_clipped_, rate_inconsistent_, accelerometer_held_;
};

}  // namespace surefoot
