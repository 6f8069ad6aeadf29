// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/attitude.hpp"

namespace surefoot {

Status read_attitude(const IMU& imu, const RobotConfig& config, Attitude& out) noexcept {
  Quaternion R_world_imu(imu.quaternion[0], imu.quaternion[1], imu.quaternion[2],
                         imu.quaternion[3]);
  const double norm = R_world_imu.norm();
  if (!(std::abs(norm - 1.0) <= 0.05)) return Status::kBadQuaternion;
  R_world_imu.normalize();

  const Eigen::Vector4d& mount = config.quat_base_imu;
  const Quaternion R_base_imu(mount[0], mount[1], mount[2], mount[3]);
  out.R_world_base = R_world_imu * R_base_imu.conjugate();
  out.w_base = R_base_imu * Vector3(imu.gyroscope[0], imu.gyroscope[1], imu.gyroscope[2]);
  out.f_base =
      R_base_imu * Vector3(imu.accelerometer[0], imu.accelerometer[1], imu.accelerometer[2]);
  out.p_base_imu = config.p_base_imu;
  return Status::kOk;
}

}  // namespace surefoot
