// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/fault_log.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Holds the IMU's attitude and its gyroscope against each other, in every mode. Real-time: yes.
class ImuWatch {
 public:
  /// @param step [s] since the last look @param anew has anything in the report changed?
  /// @param may_roll may the body turn fast for longer than a push? A gyroscope's scale is then
  /// seen
  void update(const IMU& imu, double step, bool anew, bool may_roll) noexcept;
  /// May the last report's rates be acted upon? No body turns so much faster from one to the next.
  bool rates_fit() const noexcept { return rates_fit_; }
  /// May its attitude? One that jumps more than the gyroscope turned may not.
  bool attitude_fits() const noexcept { return attitude_fits_; }
  /// Has the gyroscope stopped, clipped, or gone its own way for long? Of the last update.
  bool gyroscope_bad() const noexcept { return gyroscope_bad_; }
  /// Has the accelerometer stopped?
  bool accelerometer_bad() const noexcept { return accelerometer_bad_; }

 private:
  void judge_rates(const Vector3& w, double step, bool anew, double most_off) noexcept;
  void judge_accelerometer(const Vector3& a, double step, bool anew) noexcept;
  bool follows(const Quaternion& attitude, const Vector3& w) const noexcept;

  Quaternion R_ = Quaternion::Identity();     // world to IMU, carried on by the gyroscope
  Quaternion last_ = Quaternion::Identity();  // as reported
  Vector3 w_last_ = Vector3::Zero();          // [rad/s]
  Vector3 off_ = Vector3::Zero();             // [rad/s] gyroscope less attitude's rate, smoothed
  double rate_ = 0.0;                         // [rad/s] of the gyroscope, smoothed
  double against_ = 0.0;                      // [s] since the attitude was last believed
  bool started_ = false, gyroscope_bad_ = false, rates_fit_ = true, attitude_fits_ = true;
  Vector3 a_last_ = Vector3::Zero();  // [m/s^2]
  bool accelerometer_bad_ = false;
  Lasting held_, clipped_, away_, a_held_;
};

}  // namespace surefoot
