// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/debounce.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Compares the IMU's attitude with its gyroscope, in every mode.
///
/// The gyroscope propagates the last accepted attitude. An attitude that jumps away from it is not
/// plausible; after 0.5 s a new one is accepted. The mean difference between the gyroscope and the
/// rate of the attitude shows a gyroscope that drifts. Values that stand still or clip show a
/// sensor that has stopped. Real-time: yes.
class ImuMonitor {
 public:
  /// Judge the IMU of a sample.
  /// @param step [s] since the last update @param changed whether any value of the sample changed
  /// @param may_turn_fast whether the body may turn fast for longer than a push lasts; the
  /// tolerance then covers an error of the gyroscope's scale
  void update(const IMU& imu, double step, bool changed, bool may_turn_fast) noexcept;
  /// Return whether the rates of the last sample are usable: no body changes its rate faster.
  bool rates_plausible() const noexcept { return rates_plausible_; }
  /// Return whether its attitude is usable: it jumps no further than the gyroscope turned.
  bool attitude_plausible() const noexcept { return attitude_plausible_; }
  /// Return whether the gyroscope has stopped, clips, or disagrees with the attitude for long.
  bool gyroscope_bad() const noexcept { return gyroscope_bad_; }
  /// Return whether the accelerometer has stopped.
  bool accelerometer_bad() const noexcept { return accelerometer_bad_; }

 private:
  void judge_rates(const Vector3& w, double step, bool changed, double max_error) noexcept;
  void judge_accelerometer(const Vector3& a, double step, bool changed) noexcept;
  bool is_consistent(const Quaternion& attitude, const Vector3& w) const noexcept;

  Quaternion R_ = Quaternion::Identity();              // IMU to world, propagated by the gyroscope
  Quaternion last_attitude_ = Quaternion::Identity();  // as reported
  Vector3 w_last_ = Vector3::Zero();                   // [rad/s]
  Vector3 rate_error_ = Vector3::Zero();  // [rad/s] gyroscope less rate of attitude, mean
  double mean_rate_ = 0.0;                // [rad/s] of the gyroscope
  double rejected_time_ = 0.0;            // [s] since the last accepted attitude
  bool started_ = false, gyroscope_bad_ = false, rates_plausible_ = true,
       attitude_plausible_ = true;
  Vector3 a_last_ = Vector3::Zero();  // [m/s^2]
  bool accelerometer_bad_ = false;
  Debounce gyroscope_held_, gyroscope_clipped_, rate_inconsistent_, accelerometer_held_;
};

}  // namespace surefoot
