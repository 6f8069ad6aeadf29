// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/imu/imu_reader.hpp"

namespace surefoot {

/// Holds the vendor's attitude against ours: a second opinion from the same IMU, never a
/// measurement. Real-time: yes.
class QuaternionCheck {
 public:
  /// @param sigma of our tilt [rad]
  void update(const ImuReading& imu, const Matrix3& R_world_base, double sigma, double dt) noexcept;
  SensorVerdict verdict() const noexcept { return verdict_; }
  double tilt_difference() const noexcept { return tilt_difference_; }  ///< [rad] between the two
  void reset() noexcept { *this = QuaternionCheck(); }

 private:
  SensorVerdict verdict_ = SensorVerdict::kUnjudged;
  double tilt_difference_ = 0.0;
  double contradiction_time_ = 0.0;  // [s]
};

}  // namespace surefoot
