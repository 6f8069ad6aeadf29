// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/robot_config.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Base orientation and rates, from the IMU at its mount.
struct Attitude {
  Quaternion R_world_base = Quaternion::Identity();
  Vector3 w_base = Vector3::Zero();      ///< [rad/s] base axes
  Vector3 f_base = Vector3::Zero();      ///< [m/s^2] specific force at the IMU, base axes
  Vector3 p_base_imu = Vector3::Zero();  ///< [m]
};

/// Turn the IMU's words into base axes: R_world_base = R_world_imu R_base_imu'.
///
/// The vendor's quaternion (w x y z) is renormalised within 5 % of unit length and refused outside.
/// @return kOk, or kBadQuaternion with `out` as it was. Real-time: yes.
Status read_attitude(const IMU& imu, const RobotConfig& config, Attitude& out) noexcept;

}  // namespace surefoot
