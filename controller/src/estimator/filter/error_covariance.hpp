// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Index of the first entry of each part of the filter's error.
namespace error_index {
constexpr int kRotation = 0;
constexpr int kVelocity = 3;
constexpr int kPosition = 6;
constexpr int kFeet = 9;  ///< three entries per foot
constexpr int kGyroscopeBias = 21;
constexpr int kAccelerometerBias = 24;
constexpr int kSole = 27;  ///< compliance of the soles
constexpr int kSize = 28;
/// Number of entries on the group, which come before the biases.
constexpr int kGroupSize = kGyroscopeBias;
}  // namespace error_index

/// Propagation of the error xi over one tick: xi_next = Phi xi + noise. The error on the group is
/// xi without the biases.
struct ErrorPropagation {
  /// Derivative of the error on the group with respect to the angular rate:
  /// [R; v x R; p x R; d x R] dt, with d for each contact point.
  Eigen::Matrix<double, error_index::kGroupSize, 3> rate_jacobian;
  /// R dt: derivative of the velocity with respect to the specific force.
  Matrix3 force_jacobian;
  double dt = 0.0;                            ///< [s]
  double rate_variance = 0.0;                 ///< [rad^2/s^2] gyroscope noise of this tick
  double force_variance = 0.0;                ///< [m^2/s^4] accelerometer noise of this tick
  Eigen::Vector4d foot_variance;              ///< [m^2] process noise of each contact point
  double gyroscope_drift_variance = 0.0;      ///< [rad^2/s^2] process noise of the gyroscope bias
  double accelerometer_drift_variance = 0.0;  ///< [m^2/s^4] process noise of the accelerometer bias
  double accelerometer_bias_decay = 1.0;      ///< share of the bias that remains after the tick
  Vector3 up_base = Vector3::UnitZ();         ///< vertical, base axes, unit length
  /// [m^2/s^4] Additional process noise of the accelerometer bias along up_base.
  double vertical_drift_variance = 0.0;
  double sole_drift_variance = 0.0;  ///< [m^2] process noise of the compliance of the soles
};

/// Covariance P of the filter's error, shape (28, 28).
///
/// Only the lower triangle is valid between calls: P_[j][i] is row i of column j, for i >= j.
/// propagate() and correct() take most of the estimator's computing time, so most of their loops
/// have constant length and run over padded columns. Real-time: yes.
class ErrorCovariance {
 public:
  static constexpr int kPaddedSize = 28;  // even, so that a column consists of whole SIMD vectors
  using Columns = double[3][kPaddedSize];

  ErrorCovariance();

  double operator()(int i, int j) const noexcept { return i < j ? P_[i][j] : P_[j][i]; }
  /// Set the variances of `count` errors, starting at index `first`, and set their covariances to
  /// zero.
  void set_variance(int first, int count, double variance) noexcept;
  /// Add `variance` to the variances of `count` errors, starting at index `first`.
  void add_variance(int first, int count, double variance) noexcept;

  /// Propagate over one tick: P_next = Phi P Phi^T + Q.
  void propagate(const ErrorPropagation& motion) noexcept;

  /// Compute P H^T for the measurement of a foot, with
  /// H xi = xi_p - xi_d + xi_R x lever + xi_sole load.
  /// @param lever vector from the contact point to the centre of the foot, world axes [m]
  /// @param load load of the foot, as a share of the weight, times the normal of the ground
  /// @param out P H^T, shape (kSize, 3), stored by columns
  void project(int leg, const Vector3& lever, const Vector3& load, Columns& out) const noexcept;

  /// Compute P H^T for the measurement of the velocity, with H xi = xi_v.
  /// @param out P H^T, shape (kSize, 3), stored by columns
  void project_velocity(Columns& out) const noexcept;

  /// Update with a measurement z = H xi + noise of variance R, in the expanded Joseph form:
  ///   (I - K H) P (I - K H)^T + K R K^T = P - K M^T - M K^T
  ///   with M = W - K S / 2,  W = P H^T,  S = H P H^T + R
  /// The result is symmetric, and correct even if the gain K is inexact.
  void correct(const Columns& W, const Columns& K, const Matrix3& S) noexcept;

 private:
  void multiply_transition(const ErrorPropagation& motion) noexcept;
  void fill_upper_triangle() noexcept;
  void transpose() noexcept;

  alignas(16) double P_[kPaddedSize][kPaddedSize];  // stored by columns
};

}  // namespace surefoot
