// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/imu/quaternion_tilt_check.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// The tilts contradict each other if they differ by more than kMaxTiltDifference + kSigmaFactor
// sigma, where sigma is the standard deviation of the filter's tilt.
//
// [rad] Error of an IMU's attitude filter under acceleration, 5 deg. Chosen smaller than 10 deg, at
// which arming rejects a quaternion. Test: quaternion_disagrees_after_1_s_of_contradiction.
constexpr double kMaxTiltDifference = 0.0873;
// Factor of sigma. Chosen equal to the default of the gain gate_foot.
constexpr double kSigmaFactor = 4.0;
// [s] Duration of a contradiction after which the verdict changes. Chosen longer than a push of
// 0.1 s, which disturbs the IMU's attitude filter. If larger: a robot whose estimate is wrong
// balances with a wrong tilt for longer.
constexpr double kDetectionTime = 1.0;
}  // namespace

void QuaternionTiltCheck::update(const ImuReading& imu, const Matrix3& R_world_base, double sigma,
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
