// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/imu/imu_reader.hpp"

namespace surefoot {

/// Compares the tilt of the IMU quaternion with the tilt of the filter.
///
/// The IMU computes its quaternion from the gyroscope and accelerometer that the filter uses too.
/// So the quaternion is a check only, and no independent measurement. Real-time: yes.
class QuaternionTiltCheck {
 public:
  /// Process one sample.
  /// @param R_world_base attitude of the filter
  /// @param sigma standard deviation of the filter's tilt [rad]
  void update(const ImuReading& imu, const Matrix3& R_world_base, double sigma, double dt) noexcept;
  SensorVerdict verdict() const noexcept { return verdict_; }
  /// Angle between the verticals of quaternion and filter [rad].
  double tilt_difference() const noexcept { return tilt_difference_; }
  void reset() noexcept { *this = QuaternionTiltCheck(); }

 private:
  SensorVerdict verdict_ = SensorVerdict::kUnjudged;
  double tilt_difference_ = 0.0;
  // [s] Rises while the tilts contradict each other, falls otherwise.
  double contradiction_time_ = 0.0;
};

}  // namespace surefoot
