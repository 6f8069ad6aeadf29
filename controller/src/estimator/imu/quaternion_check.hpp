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
  Verdict verdict() const noexcept { return verdict_; }
  double tilt_apart() const noexcept { return apart_; }  ///< [rad] between the two
  void reset() noexcept { *this = QuaternionCheck(); }

 private:
  Verdict verdict_ = Verdict::kUnjudged;
  double apart_ = 0.0;
  double against_ = 0.0;  // [s]
};

}  // namespace surefoot
