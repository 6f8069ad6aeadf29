// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/debounce.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Holds the IMU's attitude and its gyroscope against each other, in every mode. Real-time: yes.
class ImuMonitor {
 public:
  /// @param step [s] since the last look @param changed has anything in the report changed?
  /// @param may_turn_fast may the body turn fast for longer than a push? A gyroscope's scale is
  /// then seen
  void update(const IMU& imu, double step, bool changed, bool may_turn_fast) noexcept;
  /// May the last report's rates be acted upon? No body turns so much faster from one to the next.
  bool rates_plausible() const noexcept { return rates_plausible_; }
  /// May its attitude? One that jumps more than the gyroscope turned may not.
  bool attitude_plausible() const noexcept { return attitude_plausible_; }
  /// Has the gyroscope stopped, clipped, or gone its own way for long? Of the last update.
  bool gyroscope_bad() const noexcept { return gyroscope_bad_; }
  /// Has the accelerometer stopped?
  bool accelerometer_bad() const noexcept { return accelerometer_bad_; }

 private:
  void judge_rates(const Vector3& w, double step, bool changed, double max_error) noexcept;
  void judge_accelerometer(const Vector3& a, double step, bool changed) noexcept;
  bool is_consistent(const Quaternion& attitude, const Vector3& w) const noexcept;

  Quaternion R_ = Quaternion::Identity();              // world to IMU, carried on by the gyroscope
  Quaternion last_attitude_ = Quaternion::Identity();  // as reported
  Vector3 w_last_ = Vector3::Zero();                   // [rad/s]
  Vector3 rate_error_ = Vector3::Zero();  // [rad/s] gyroscope less attitude's rate, smoothed
  double mean_rate_ = 0.0;                // [rad/s] of the gyroscope, smoothed
  double rejected_time_ = 0.0;            // [s] since the attitude was last believed
  bool started_ = false, gyroscope_bad_ = false, rates_plausible_ = true,
       attitude_plausible_ = true;
  Vector3 a_last_ = Vector3::Zero();  // [m/s^2]
  bool accelerometer_bad_ = false;
  Debounce gyroscope_held_, gyroscope_clipped_, rate_inconsistent_, accelerometer_held_;
};

}  // namespace surefoot
