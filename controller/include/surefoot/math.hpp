// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "surefoot/low_level.hpp"

// The pip wheels of Pinocchio are built without AVX. When two libraries disagree on Eigen's
// alignment, memory that one allocates and the other frees corrupts the heap. So a translation unit
// that is built with -mavx, -march=native or similar flags must not compile.
#if defined(__x86_64__) && !defined(SUREFOOT_SOURCE_BUILT_PINOCCHIO)
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_DEFAULT_ALIGN_BYTES == 16,
              "surefoot: Eigen would align memory differently from the Pinocchio wheel; build "
              "without AVX flags (-mavx*, -march=x86-64-v3, -march=native)");
#endif

/// Fixed-size types of a quadruped with 3-joint legs.
namespace surefoot {

using Vector3 = Eigen::Vector3d;                ///< column of 3, such as a position or a force
using Vector6 = Eigen::Matrix<double, 6, 1>;    ///< column of 6: linear part first, then angular
using Vector12 = Eigen::Matrix<double, 12, 1>;  ///< column of 12, one entry per motor
using Matrix3 = Eigen::Matrix3d;                ///< 3 x 3 matrix
using Matrix6 = Eigen::Matrix<double, 6, 6>;    ///< 6 x 6 matrix
using Quaternion = Eigen::Quaterniond;          ///< unit quaternion of an orientation

constexpr double kGravity = 9.81;  ///< [m/s^2] gravity; the default of Pinocchio and MuJoCo

/// One 3-vector per foot, as columns FR FL RR RL.
using FeetMatrix = Eigen::Matrix<double, 3, kLegs>;

/// Compute the cross-product matrix of a: skew(a) b = a x b. Real-time: yes.
inline Matrix3 skew(const Vector3& a) {
  Matrix3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

/// Convert coefficients (w, x, y, z), the order of the SDK and of files, to a quaternion.
/// Real-time: yes.
inline Quaternion quaternion_wxyz(const Eigen::Vector4d& wxyz) {
  return Quaternion(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

/// Compute the rotation vector [rad] of a unit quaternion; its angle is at most pi. Real-time: yes.
inline Vector3 log_so3(const Quaternion& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const double half_angle_sine = q.vec().norm();
  const double scale = half_angle_sine < 1e-9
                           ? 2.0
                           : 2.0 * std::atan2(half_angle_sine, sign * q.w()) / half_angle_sine;
  return sign * scale * q.vec();
}

/// Compute the unit quaternion of a rotation vector [rad]. Real-time: yes.
inline Quaternion exp_so3(const Vector3& w) {
  const double angle = w.norm();
  const double scale = angle < 1e-9 ? 0.5 : std::sin(0.5 * angle) / angle;
  Quaternion q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = scale * w;
  return q;
}

}  // namespace surefoot
