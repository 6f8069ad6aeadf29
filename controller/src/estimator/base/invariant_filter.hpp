// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/base/error_covariance.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Standard deviations that a filter starts with.
struct InitialSigmas {
  double tilt = 0.0;           ///< [rad]
  double velocity = 0.0;       ///< [m/s]
  double foot = 0.0;           ///< [m]
  double gyroscope = 0.0;      ///< [rad/s]
  double accelerometer = 0.0;  ///< [m/s^2]
};

/// What one tick's IMU says, and how sure it is.
struct ImuInput {
  Vector3 w_base = Vector3::Zero();  ///< [rad/s] as read
  Vector3 f_base = Vector3::Zero();  ///< [m/s^2] specific force as read
  double w_variance = 0.0;           ///< [rad^2/s^2]
  double f_variance = 0.0;           ///< [m^2/s^4]
  double dt = 0.0;                   ///< [s]
};

/// Contact-aided invariant extended Kalman filter for orientation, velocity, position, contact
/// points and the IMU's biases.
///
/// State of the IMU's own point, X = (R, v, p, d_1 .. d_4) on SE_6(3), and biases in base axes.
/// The error is right-invariant, X_estimate = exp(xi) X: its motion does not depend on the state
/// but through the biases, so it converges from far and learns nothing of what cannot be seen (yaw,
/// position, and the horizontal accelerometer bias at rest). Hartley, Ghaffari, Eustice, Grizzle
/// 2020, "Contact-aided invariant extended Kalman filtering for robot state estimation", sections
/// IV and V. Real-time: yes.
class InvariantFilter {
 public:
  /// Begin at rest. @param p IMU's point, @param p_feet contact points, world axes [m]
  void reset(const Quaternion& R, const Vector3& v, const Vector3& p, const FeetMatrix& p_feet,
             const InitialSigmas& sigmas) noexcept;

  /// Doubt anew what has been found so far.
  void reset_covariance(const InitialSigmas& sigmas) noexcept;

  /// Biases are zero again. Their doubt stays as it is.
  void reset_biases() noexcept {
    gyroscope_bias_.setZero();
    accelerometer_bias_.setZero();
  }
  /// Is the estimate one that a robot may have? What is not does not come back by itself.
  bool is_plausible() const noexcept;

  /// Move on by one IMU reading.
  /// @param foot_variance [m^2] that each may have moved besides
  void predict(const Gains& gains, const ImuInput& imu,
               const Eigen::Vector4d& foot_variance) noexcept;

  /// Contact points have travelled, by rolling. @param displacement world axes [m]
  void move_feet(const FeetMatrix& displacement) noexcept { feet_ += displacement; }

  /// Take in where the legs say the contact points are.
  /// @param y_base from the IMU's point, base axes [m], @param variance [m^2] of each
  /// @param gate standard deviations beyond which a foot counts for less (as if its
  /// measurement were as noisy as its surprise); beyond kRejectionRatio times that it is refused
  /// @param lever [m] from a contact point to its sole's centre, world axes; the measurement is
  /// linearised at one that is kept until it has turned by 10 mrad
  void correct(const FeetMatrix& y_base, const Eigen::Vector4d& variance, double gate,
               const Vector3& lever) noexcept;

  const Matrix3& R_world_base() const noexcept { return R_; }
  const Quaternion& quaternion() const noexcept { return q_; }
  const Vector3& v() const noexcept { return v_; }
  const Vector3& p() const noexcept { return p_; }
  const FeetMatrix& feet() const noexcept { return feet_; }
  const Vector3& gyroscope_bias() const noexcept { return gyroscope_bias_; }
  const Vector3& accelerometer_bias() const noexcept { return accelerometer_bias_; }
  const ErrorCovariance& covariance() const noexcept { return P_; }

  /// Of the last correct(): refused feet; normalised innovation squared of the others.
  const std::array<bool, kLegs>& rejected_feet() const noexcept { return rejected_feet_; }
  double nis() const noexcept { return nis_; }
  int nis_dimension() const noexcept { return nis_dimension_; }
  /// The same foot by foot, and the innovations' variance without the measurement's own [m^2].
  const Eigen::Vector4d& foot_nis() const noexcept { return foot_nis_; }
  const Eigen::Vector4d& predicted_variance() const noexcept { return predicted_variance_; }

  /// More doubt about the velocity: a blow has clipped the accelerometer.
  void add_velocity_variance(double variance) noexcept {
    P_.add_variance(error_index::kVelocity, 3, variance);
  }

 private:
  static constexpr double kRejectionRatio = 5.0;
  using Error = Eigen::Matrix<double, ErrorCovariance::kPaddedSize, 1>;
  void correct_foot(int leg, const Vector3& z, double variance, double gate, const Vector3& lever,
                    Error& xi) noexcept;
  void apply(const Error& xi) noexcept;
  void relinearise() noexcept;
  void relinearise(const Vector3& lever) noexcept;

  Quaternion q_ = Quaternion::Identity();
  Matrix3 R_ = Matrix3::Identity();
  Matrix3 R_linearisation_ = Matrix3::Identity();  // attitude that the error's motion is made at
  Vector3 lever_linearisation_ = Vector3::Zero();  // lever that the measurement is made at
  Vector3 v_ = Vector3::Zero(), p_ = Vector3::Zero();
  FeetMatrix feet_ = FeetMatrix::Zero();
  Vector3 gyroscope_bias_ = Vector3::Zero(), accelerometer_bias_ = Vector3::Zero();
  ErrorCovariance P_;
  std::array<bool, kLegs> rejected_feet_{};
  Eigen::Vector4d foot_nis_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d predicted_variance_ = Eigen::Vector4d::Zero();
  double nis_ = 0.0;
  int nis_dimension_ = 0;
};

}  // namespace surefoot
