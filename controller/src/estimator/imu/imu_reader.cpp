// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/imu/imu_reader.hpp"

#include "low_state_check.hpp"

namespace surefoot {

namespace {
constexpr double kForceRange = 156.0;  // [m/s^2] full scale of 16 g
}  // namespace

void ImuReader::Stillness::see(const Vector3& value, bool moved, double dt) noexcept {
  if (value == last) {
    // A report that repeats as a whole says that nothing has changed, this signal included.
    age += moved;
    held += moved ? dt : 0.0;
    return;
  }
  last = value;
  age = 1;
  held = 0.0;
}

Verdict ImuReader::Stillness::verdict(double limit) const noexcept {
  if (last.cwiseAbs().maxCoeff() >= limit) return Verdict::kSaturated;
  if (held < kHeld) return Verdict::kGood;
  return last.isZero(0.0) ? Verdict::kZero : Verdict::kConstant;
}

void ImuReader::read(const IMU& imu, const RobotConfig& config, const Vector12& joints, double dt,
                     ImuReading& out) noexcept {
  // Packed fields are not aligned: copy them before indexing.
  const std::array<float, 4> quaternion = imu.quaternion;
  const std::array<float, 3> gyroscope = imu.gyroscope, accelerometer = imu.accelerometer;
  const Quaternion R_base_imu = quaternion_wxyz(config.quat_base_imu);
  const Vector3 w(gyroscope[0], gyroscope[1], gyroscope[2]);
  const Vector3 f(accelerometer[0], accelerometer[1], accelerometer[2]);
  const bool moved = joints != joints_;
  joints_ = joints;
  out.anew = moved || w != gyroscope_.last || f != accelerometer_.last;
  gyroscope_.see(w, moved, dt);
  accelerometer_.see(f, moved, dt);
  out.w_base = R_base_imu * w;
  out.f_base = R_base_imu * f;
  out.w_age = gyroscope_.age;
  out.f_age = accelerometer_.age;
  out.gyroscope = gyroscope_.verdict(kRateRange);
  out.accelerometer = accelerometer_.verdict(kForceRange);

  Quaternion R_world_imu(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  out.has_quaternion = has_quaternion(imu);
  out.quaternion = out.has_quaternion          ? Verdict::kGood
                   : R_world_imu.norm() == 0.0 ? Verdict::kZero
                                               : Verdict::kImplausible;
  if (!out.has_quaternion) return;
  R_world_imu.normalize();
  out.R_world_base = R_world_imu * R_base_imu.conjugate();
}

}  // namespace surefoot
