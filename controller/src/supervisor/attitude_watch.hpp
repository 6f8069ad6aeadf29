// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "low_state_check.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Holds the IMU's attitude against its own gyroscope: one that jumps is not to be acted upon.
/// Real-time: yes.
class AttitudeWatch {
 public:
  static constexpr double kJump = 0.1;    ///< [rad] more than the gyroscope turned
  static constexpr double kTurn = 0.02;   ///< [s] of its rate that it may be late
  static constexpr double kForget = 0.5;  ///< [s] after which a new attitude is taken as it is

  /// Is the attitude of this report to be believed? @param step [s] since the one before
  bool update(const IMU& imu, double step) noexcept {
    const std::array<float, 4> q = imu.quaternion;  // packed: copied
    const std::array<float, 3> w = imu.gyroscope;
    const Vector3 rate(w[0], w[1], w[2]);
    const double angle = rate.norm() * step;
    if (angle > 0.0) R_ = R_ * Quaternion(Eigen::AngleAxisd(angle, rate.normalized()));
    against_ += step;
    if (!has_quaternion(imu)) return false;
    const Quaternion now = Quaternion(q[0], q[1], q[2], q[3]).normalized();
    const bool follows = now.angularDistance(R_) < kJump + kTurn * rate.norm();
    if (!follows && started_ && against_ < kForget) return false;
    R_ = now;
    started_ = true;
    against_ = 0.0;
    return true;
  }

 private:
  Quaternion R_ = Quaternion::Identity();  // world to IMU, carried on by the gyroscope
  double against_ = 0.0;                   // [s] since it was last believed
  bool started_ = false;
};

}  // namespace surefoot
