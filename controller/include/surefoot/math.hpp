// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "surefoot/low_level.hpp"

// The pip wheels of Pinocchio are built without AVX. Eigen memory that is allocated on one side and
// freed on the other corrupts the heap when the two sides disagree on alignment, so a translation
// unit built with -mavx, -march=native and the like must not compile.
#if defined(__x86_64__) && !defined(SUREFOOT_SOURCE_BUILT_PINOCCHIO)
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_DEFAULT_ALIGN_BYTES == 16,
              "surefoot: build without AVX flags (-mavx*, -march=x86-64-v3, -march=native): Eigen "
              "would align memory otherwise than the Pinocchio wheel does");
#endif

/// Fixed-size vocabulary of a quadruped with 3-joint legs.
namespace surefoot {

using Vector3 = Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix3 = Eigen::Matrix3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Quaternion = Eigen::Quaterniond;

constexpr double kGravity = 9.81;  ///< [m/s^2] Pinocchio's and MuJoCo's default

/// One column a foot, FR FL RR RL.
using FeetMatrix = Eigen::Matrix<double, 3, kLegs>;

/// Cross-product matrix: skew(a) b = a x b.
inline Matrix3 skew(const Vector3& a) {
  Matrix3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

/// The quaternion whose coefficients are written (w, x, y, z), as the SDK and files have them.
inline Quaternion quaternion_wxyz(const Eigen::Vector4d& wxyz) {
  return Quaternion(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

/// Rotation vector of a unit quaternion, the short way round (angle at most pi).
inline Vector3 log_so3(const Quaternion& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const double sine = q.vec().norm();
  const double scale = sine < 1e-9 ? 2.0 : 2.0 * std::atan2(sine, sign * q.w()) / sine;
  return sign * scale * q.vec();
}

/// Unit quaternion of a rotation vector.
inline Quaternion exp_so3(const Vector3& w) {
  const double angle = w.norm();
  const double scale = angle < 1e-9 ? 0.5 : std::sin(0.5 * angle) / angle;
  Quaternion q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = scale * w;
  return q;
}

}  // namespace surefoot
