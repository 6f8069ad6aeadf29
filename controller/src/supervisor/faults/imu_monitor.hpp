// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/debounce.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// How the body moves.
enum class ImuMotion {
  kStands,  ///< it turns only while a push lasts
  kTurns,   ///< it may turn fast for longer, so the scale error of the gyroscope matters
  kSteps    ///< it may turn fast, and touchdowns make the gyroscope vibrate
};

/// Compares the attitude that the IMU measures with the gyroscope, in every mode.
///
/// The last accepted attitude is propagated with the gyroscope. A measured attitude that jumps away
/// from the propagated attitude is not plausible. After 0.5 s of such attitudes, the next measured
/// attitude is accepted. A gyroscope drift appears as a mean difference between the gyroscope and
/// the rate of the attitude. A stopped sensor repeats its values; an overloaded sensor sends values
/// at the end of its range (clipped). Real-time: yes.
class ImuMonitor {
 public:
  /// Check the IMU of a sample.
  /// @param step [s] time since the last update
  /// @param changed true if any IMU or joint value differs from the previous sample
  /// @param motion how the body moves
  void update(const IMU& imu, double step, bool changed, ImuMotion motion) noexcept;
  /// Return whether the gyroscope of the last sample is usable. It is not usable if it has changed
  /// by 3 rad/s or more since the previous sample; no body can change its rate so fast. While feet
  /// step (kSteps), touchdowns make it vibrate: the limit is 12, and 4 for the mean of 20 ms.
  bool rates_plausible() const noexcept { return rates_plausible_; }
  /// Return whether the attitude of the last sample is usable. It is not usable if the norm of the
  /// quaternion is not 1, or if the attitude has jumped away from the propagated attitude.
  bool attitude_plausible() const noexcept { return attitude_plausible_; }
  /// Return whether the gyroscope has, for 50 ms, repeated its values, been clipped, or
  /// contradicted the attitude.
  bool gyroscope_bad() const noexcept { return gyroscope_bad_; }
  /// Return whether the accelerometer has repeated its values for 50 ms.
  bool accelerometer_bad() const noexcept { return accelerometer_bad_; }

 private:
  void judge_rates(const Vector3& w, double step, bool changed, double max_error) noexcept;
  void judge_accelerometer(const Vector3& a, double step, bool changed) noexcept;
  bool judge_rate_jump(double jump, double step, ImuMotion motion) noexcept;
  bool is_consistent(const Quaternion& attitude, const Vector3& w) const noexcept;

  // Attitude of the IMU in the world, propagated by the gyroscope.
  Quaternion R_propagated_ = Quaternion::Identity();
  // Attitude of the IMU in the world, last measured.
  Quaternion last_attitude_ = Quaternion::Identity();
  Vector3 w_last_ = Vector3::Zero();      // [rad/s] gyroscope in the last sample
  Vector3 rate_error_ = Vector3::Zero();  // [rad/s] mean of gyroscope minus rate of the attitude
  double mean_rate_jump_ = 0.0;           // [rad/s] mean change of the gyroscope in a sample
  double mean_rate_ = 0.0;                // [rad/s] mean magnitude of the gyroscope
  double rejected_time_ = 0.0;            // [s] time since the last accepted attitude
  bool started_ = false, gyroscope_bad_ = false, rates_plausible_ = true,
       attitude_plausible_ = true;
  Vector3 a_last_ = Vector3::Zero();  // [m/s^2] accelerometer in the last sample
  bool accelerometer_bad_ = false;
  Debounce gyroscope_repeats_, gyroscope_clips_, rate_inconsistent_, accelerometer_repeats_;
};

}  // namespace surefoot
