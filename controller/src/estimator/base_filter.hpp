// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Kalman filter for position and velocity, from the accelerometer and the legs.
///
/// With the orientation given, the three world axes share one covariance: state per axis is
/// [p_imu, v_imu, p_foot x 4]. Prediction: v' = R f + g. Each foot measures p_foot - p_imu (joint
/// angles) and v_imu (joint velocities; a stance foot's contact point rests). Measurements beyond
/// the gate are refused, and a foot that is refused may wander, so it finds back by itself.
/// After Bloesch et al. 2012, with orientation left to the IMU. Real-time: yes.
class BaseFilter {
 public:
  /// Put the IMU point at `p_imu`, at rest, feet where the kinematics say.
  void reset(const Vector3& p_imu, const FeetMatrix& p_feet) noexcept;

  /// @param f_world specific force at the IMU, world axes [m/s^2]
  /// @param p_imu,v_imu of the IMU from the base's origin, world axes [m], [m/s]
  /// @param dynamics updated with the base at the origin and no linear velocity
  /// @param contact belief per foot, 0 .. 1
  void update(const Gains& gains, const Vector3& f_world, const Vector3& p_imu,
              const Vector3& v_imu, const Dynamics& dynamics, const Eigen::Vector4d& contact,
              double dt) noexcept;

  Vector3 p_imu() const noexcept { return x_.row(0).transpose(); }
  Vector3 v_imu() const noexcept { return x_.row(1).transpose(); }
  /// Covariance of one axis: p, v, four feet.
  const Matrix6& covariance() const noexcept { return P_; }
  /// Measurements refused by the gate in the last update, of 8.
  int refused() const noexcept { return refused_; }

 private:
  void predict(const Gains& gains, const Vector3& a_world, const Eigen::Vector4d& contact,
               double dt) noexcept;
  bool correct(const Vector6& h, const Vector3& measured, double variance, double gate) noexcept;

  Eigen::Matrix<double, 6, 3> x_ = Eigen::Matrix<double, 6, 3>::Zero();
  Matrix6 P_ = Matrix6::Identity();
  std::array<bool, kLegs> wandering_{};
  int refused_ = 0;
};

}  // namespace surefoot
