// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// One IMU report in base axes.
struct ImuReading {
  Quaternion R_world_base = Quaternion::Identity();  ///< the vendor's filter, at the mount
  Vector3 w_base = Vector3::Zero();                  ///< [rad/s] raw rate, base axes
  Vector3 f_base = Vector3::Zero();  ///< [m/s^2] specific force at the IMU, base axes
};

/// Turn the IMU's words into base axes: R_world_base = R_world_imu R_base_imu'.
///
/// The vendor's quaternion (w x y z) is renormalised within 5 % of unit length and refused outside.
/// @return kOk, or kBadQuaternion with `out` as it was. Real-time: yes.
Status read_imu(const IMU& imu, const RobotConfig& config, ImuReading& out) noexcept;

/// Orientation of the base from the raw gyroscope and accelerometer.
///
/// Starts from the vendor's quaternion, without its yaw. Then a complementary filter (Mahony,
/// Hamel, Pflimlin 2008, eq. 32a) pulls the gravity it believes in to the accelerometer's, slowly,
/// so that a push tilts it little. The gyroscope's bias comes from the legs: feet that stand do not
/// turn about each other. Vendor filters carry that bias as a tilt error. Real-time: yes.
class AttitudeFilter {
 public:
  void reset(const ImuReading& imu) noexcept;

  /// Integrate one reading. @param acceleration [m/s^2] that the commands are to make of the base:
  /// the more of it, the less the accelerometer is a plumb line
  void update(const Gains& gains, const ImuReading& imu, double acceleration, double dt) noexcept;

  /// Learn the gyroscope's bias. @param dynamics updated with w_base() and no linear velocity
  void learn_bias(const Gains& gains, const Dynamics& dynamics, const Eigen::Vector4d& contact,
                  double dt) noexcept;

  const Quaternion& R_world_base() const noexcept { return R_world_base_; }
  const Vector3& w_base() const noexcept { return w_base_; }   ///< [rad/s] bias taken off
  const Vector3& gyro_bias() const noexcept { return bias_; }  ///< [rad/s] base axes

 private:
  Quaternion R_world_base_ = Quaternion::Identity();
  Vector3 w_base_ = Vector3::Zero();
  Vector3 bias_ = Vector3::Zero();
  double age_ = 0.0;  // [s]
};

}  // namespace surefoot
