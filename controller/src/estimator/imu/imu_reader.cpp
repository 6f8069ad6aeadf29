// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/imu/imu_reader.hpp"

#include "low_level/low_state_check.hpp"

namespace surefoot {

namespace {
// [m/s^2] An accelerometer counts as saturated from this value on. Derived: just below 16 g
// (156.9), its assumed full scale.
constexpr double kForceRange = 156.0;
}  // namespace

void ImuReader::StuckVectorDetector::update(const Vector3& value, bool joints_changed,
                                            double dt) noexcept {
  if (value == last) {
    // The time counts only if the joints have changed: if the whole sample repeats, the sensor has
    // no fault.
    age += joints_changed;
    unchanged_time += joints_changed ? dt : 0.0;
    return;
  }
  last = value;
  age = 1;
  unchanged_time = 0.0;
}

SensorVerdict ImuReader::StuckVectorDetector::verdict(double limit) const noexcept {
  if (last.cwiseAbs().maxCoeff() >= limit) return SensorVerdict::kSaturated;
  if (unchanged_time < kMaxHoldTime) return SensorVerdict::kGood;
  return last.isZero(0.0) ? SensorVerdict::kZero : SensorVerdict::kConstant;
}

void ImuReader::read(const IMU& imu, const RobotConfig& config, const Vector12& joints, double dt,
                     ImuReading& out) noexcept {
  // Packed fields are not aligned, so they are copied before indexing.
  const std::array<float, 4> quaternion = imu.quaternion;
  const std::array<float, 3> gyroscope = imu.gyroscope, accelerometer = imu.accelerometer;
  const Quaternion R_base_imu = quaternion_wxyz(config.quat_base_imu);
  const Vector3 w(gyroscope[0], gyroscope[1], gyroscope[2]);
  const Vector3 f(accelerometer[0], accelerometer[1], accelerometer[2]);
  const bool joints_changed = joints != last_joints_;
  last_joints_ = joints;
  out.changed = joints_changed || w != gyroscope_.last || f != accelerometer_.last;
  gyroscope_.update(w, joints_changed, dt);
  accelerometer_.update(f, joints_changed, dt);
  out.w_base = R_base_imu * w;
  out.f_base = R_base_imu * f;
  out.w_age = gyroscope_.age;
  out.f_age = accelerometer_.age;
  out.gyroscope = gyroscope_.verdict(kRateRange);
  out.accelerometer = accelerometer_.verdict(kForceRange);

  Quaternion R_world_imu(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  out.has_quaternion = has_unit_quaternion(imu);
  out.quaternion = out.has_quaternion          ? SensorVerdict::kGood
                   : R_world_imu.norm() == 0.0 ? SensorVerdict::kZero
                                               : SensorVerdict::kImplausible;
  if (!out.has_quaternion) return;
  R_world_imu.normalize();
  out.R_world_base = R_world_imu * R_base_imu.conjugate();
}

}  // namespace surefoot
