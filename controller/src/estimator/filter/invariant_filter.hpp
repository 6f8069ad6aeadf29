// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/filter/error_covariance.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Initial standard deviations of the filter.
struct InitialSigmas {
  double tilt = 0.0;           ///< [rad] of roll and of pitch
  double velocity = 0.0;       ///< [m/s]
  double foot = 0.0;           ///< [m]
  double gyroscope = 0.0;      ///< [rad/s] of the gyroscope bias
  double accelerometer = 0.0;  ///< [m/s^2] of the accelerometer bias
  double sole = 0.0;           ///< [m] of the compliance of the soles
};

/// Measurement of the feet in one tick.
struct FeetInput {
  /// Vectors from the IMU point to the contact points of rigid soles, by the joint angles, base
  /// axes [m].
  FeetMatrix y_base = FeetMatrix::Zero();
  Eigen::Vector4d variance = Eigen::Vector4d::Zero();  ///< [m^2] noise of one coordinate
  Eigen::Vector4d load = Eigen::Vector4d::Zero();      ///< normal force / weight
  /// [m^2] Additional noise along the normal of the ground.
  Eigen::Vector4d normal_variance = Eigen::Vector4d::Zero();
  Vector3 normal = Vector3::UnitZ();  ///< of the ground, world axes, unit length
  /// Whether the load of a foot changes, so that its motion shows how far its sole yields.
  std::array<bool, kLegs> load_changes{};
  bool steps = false;                ///< true: the robot steps, see StepDetector
  std::array<bool, kLegs> slides{};  ///< FrictionEstimate::slides()
  /// Vector from a contact point of a rigid sole to the centre of its foot, world axes [m].
  Vector3 lever = Vector3::Zero();
};

/// IMU measurement of one tick, base axes, and variances of its noise. The measured values include
/// the biases.
struct ImuInput {
  Vector3 w_base = Vector3::Zero();  ///< [rad/s] angular velocity
  Vector3 f_base = Vector3::Zero();  ///< [m/s^2] specific force
  double w_variance = 0.0;           ///< [rad^2/s^2] of one axis
  double f_variance = 0.0;           ///< [m^2/s^4] of one axis
  double dt = 0.0;                   ///< [s]
};

/// Contact-aided invariant extended Kalman filter (InEKF) for orientation, velocity, position,
/// contact points and IMU biases.
///
/// The state X = (R, v, p, d_1 .. d_4) of the IMU point and the contact points is an element of the
/// group SE_6(3). The biases are not part of the group; they are vectors in base axes. Gyroscope
/// and accelerometer drive the prediction. The forward kinematics of each leg measure
/// y = R^T (d - p), the vector from the IMU point to the contact point in base axes.
///
/// The error is right-invariant, X_estimate = exp(xi) X. Its linearised dynamics and measurement
/// depend on the state only through the biases. So the filter converges from large initial errors,
/// and gains no false information about the states that are not observable: yaw, position and, at
/// rest, the horizontal accelerometer bias.
///
/// Source: Hartley, Ghaffari, Eustice, Grizzle, "Contact-aided invariant extended Kalman filtering
/// for robot state estimation", IJRR 2020. Differences from the paper: contact points roll with the
/// spherical feet; all four feet stay in the state, with large process noise while they are off the
/// ground; the accelerometer bias is a Gauss-Markov process; an innovation gate rejects feet; the
/// linearisation points of biases and lever are kept until the body or the lever has rotated by 10
/// mrad. Real-time: yes.
class InvariantFilter {
 public:
  /// Start again with zero biases.
  /// @param R attitude of the base
  /// @param v,p velocity [m/s] and position [m] of the IMU point, world axes
  /// @param p_feet contact points, world frame [m]
  void reset(const Quaternion& R, const Vector3& v, const Vector3& p, const FeetMatrix& p_feet,
             const InitialSigmas& sigmas) noexcept;

  /// Reset the covariance and keep the estimate.
  void reset_covariance(const InitialSigmas& sigmas) noexcept;

  /// Set the biases to zero and keep the covariance.
  void reset_biases() noexcept {
    gyroscope_bias_.setZero();
    accelerometer_bias_.setZero();
  }
  /// Replace attitude and biases, with a velocity of zero, and keep their covariance.
  /// @param velocity_sigma standard deviation of the velocity [m/s]
  void set_attitude(const Quaternion& R, const Vector3& gyroscope_bias,
                    const Vector3& accelerometer_bias, double velocity_sigma) noexcept;
  /// Return whether speed, biases and variances are in a range that is possible for a robot. An
  /// implausible estimate does not recover without a reset.
  bool is_plausible() const noexcept;

  /// Predict the state over one tick.
  /// @param foot_variance process noise [m^2] of each contact point, see FootMotionModel
  /// @param sole_variance process noise [m^2] of the sole compliance
  void predict(const Gains& gains, const ImuInput& imu, const Eigen::Vector4d& foot_variance,
               double sole_variance = 0.0) noexcept;

  /// Move the contact points by a known displacement, for example by rolling; world axes [m].
  void move_feet(const FeetMatrix& displacement) noexcept { feet_ += displacement; }

  /// Correct the estimate with the contact points from forward kinematics.
  /// @param gate limit of a foot's innovation [standard deviations]. Above it, the
  ///   measurement noise of the foot is increased so that the innovation is about at the limit; the
  ///   variance of its position instead if the foot slides. Above kRejectionRatio * gate, the foot
  ///   is rejected
  void correct(const FeetInput& feet, double gate) noexcept;

  /// Correct the estimate with the measurement that the velocity of the IMU point is zero.
  /// @param variance of one coordinate [m^2/s^2]
  void correct_zero_velocity(double variance) noexcept;

  const Matrix3& R_world_base() const noexcept { return R_; }
  const Quaternion& quaternion() const noexcept { return q_; }
  const Vector3& v() const noexcept { return v_; }
  const Vector3& p() const noexcept { return p_; }
  const FeetMatrix& feet() const noexcept { return feet_; }
  const Vector3& gyroscope_bias() const noexcept { return gyroscope_bias_; }
  const Vector3& accelerometer_bias() const noexcept { return accelerometer_bias_; }
  /// Depth [m] by which the soles yield under the weight of the robot.
  double sole_compliance() const noexcept { return sole_compliance_; }
  const ErrorCovariance& covariance() const noexcept { return P_; }

  // Results of the last correct():
  /// True for each foot that the gate rejected.
  const std::array<bool, kLegs>& rejected_feet() const noexcept { return rejected_feet_; }
  /// Normalised innovation squared, summed over all feet that were not rejected, and its dimension.
  double nis() const noexcept { return nis_; }
  int nis_dimension() const noexcept { return nis_dimension_; }
  /// For each foot: normalised innovation squared, and variance [m^2] of one coordinate of the
  /// innovation without measurement noise.
  const Eigen::Vector4d& foot_nis() const noexcept { return foot_nis_; }
  const Eigen::Vector4d& predicted_variance() const noexcept { return predicted_variance_; }

  /// Increase the variance of the velocity, for example after the accelerometer was saturated.
  void add_velocity_variance(double variance) noexcept {
    P_.add_variance(error_index::kVelocity, 3, variance);
  }

 private:
  // Innovation above which a foot is rejected, in units of the gain gate_foot. If the innovation is
  // between 1 and this value, the foot only gets less weight. Chosen: the filter must still use a
  // foot that slips slowly, but not a foot whose innovation is 20 standard deviations
  // (docs/explanation/estimator.md).
  static constexpr double kRejectionRatio = 5.0;
  using Error = Eigen::Matrix<double, ErrorCovariance::kPaddedSize, 1>;
  void correct_foot(int leg, const Vector3& z, const FeetInput& feet, double gate,
                    Error& xi) noexcept;
  void apply(const Error& xi) noexcept;
  void relinearise() noexcept;
  void relinearise(const Vector3& lever) noexcept;

  Quaternion q_ = Quaternion::Identity();
  Matrix3 R_ = Matrix3::Identity();
  Matrix3 R_linearisation_ = Matrix3::Identity();  // attitude at which the biases are linearised
  Vector3 lever_linearisation_ = Vector3::Zero();  // lever at which the measurement is linearised
  Vector3 v_ = Vector3::Zero(), p_ = Vector3::Zero();
  FeetMatrix feet_ = FeetMatrix::Zero();
  Vector3 gyroscope_bias_ = Vector3::Zero(), accelerometer_bias_ = Vector3::Zero();
  double sole_compliance_ = 0.0;
  ErrorCovariance P_;
  std::array<bool, kLegs> rejected_feet_{};
  Eigen::Vector4d foot_nis_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d predicted_variance_ = Eigen::Vector4d::Zero();
  double nis_ = 0.0;
  int nis_dimension_ = 0;
};

}  // namespace surefoot
