// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/imu/quaternion_check.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// [rad] 5 deg: error of an IMU's attitude filter under acceleration.
constexpr double kMaxTiltDifference = 0.0873;
constexpr double kSigmaFactor = 4.0;    // standard deviations of the filter's tilt, added to it
constexpr double kDetectionTime = 1.0;  // [s] of contradiction before the verdict changes
}  // namespace

void QuaternionCheck::update(const ImuReading& imu, const Matrix3& R_world_base, double sigma,
                             double dt) noexcept {
  if (!imu.has_quaternion) {
    verdict_ = imu.quaternion;
    return;
  }
  const Vector3 up = imu.R_world_base.conjugate() * Vector3::UnitZ();
  tilt_difference_ = std::acos(std::clamp(up.dot(R_world_base.row(2).transpose()), -1.0, 1.0));
  const bool contradicts = tilt_difference_ > kMaxTiltDifference + kSigmaFactor * sigma;
  contradiction_time_ =
      std::clamp(contradiction_time_ + (contradicts ? dt : -dt), 0.0, 2.0 * kDetectionTime);
  verdict_ =
      contradiction_time_ > kDetectionTime ? SensorVerdict::kDisagrees : SensorVerdict::kGood;
}

}  // namespace surefoot
