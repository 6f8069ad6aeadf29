// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// First index of each part of the filter's error.
namespace error_index {
constexpr int kRotation = 0;
constexpr int kVelocity = 3;
constexpr int kPosition = 6;
constexpr int kFeet = 9;  ///< three per foot
constexpr int kGyroscopeBias = 21;
constexpr int kAccelerometerBias = 24;
constexpr int kSize = 27;
constexpr int kGroupSize = kGyroscopeBias;  ///< size of the part on the group; the biases follow
}  // namespace error_index

/// Propagation of the error over one tick: xi' = Phi xi + noise.
struct ErrorPropagation {
  /// Derivative of the error on the group by the angular rate: [R; v x R; p x R; d x R] dt.
  Eigen::Matrix<double, error_index::kGroupSize, 3> rate_jacobian;
  Matrix3 force_jacobian;                     ///< R dt: velocity by specific force
  double dt = 0.0;                            ///< [s]
  double rate_variance = 0.0;                 ///< [rad^2/s^2] of the gyroscope over this tick
  double force_variance = 0.0;                ///< [m^2/s^4] of the accelerometer over this tick
  Eigen::Vector4d foot_variance;              ///< [m^2] by motion of each contact point
  double gyroscope_drift_variance = 0.0;      ///< [rad^2/s^2] of the bias in this tick
  double accelerometer_drift_variance = 0.0;  ///< [m^2/s^4]
  double accelerometer_bias_decay = 1.0;      ///< share of the bias that remains
  Vector3 up_base = Vector3::UnitZ();         ///< vertical, base axes
  double vertical_drift_variance = 0.0;       ///< [m^2/s^4] additional, along up_base
};

/// Covariance P of the filter's error, shape (27, 27).
///
/// Only the lower triangle is stored. propagate() and correct() take most of the estimator's time,
/// so they run mostly in loops of constant length over padded columns. Real-time: yes.
class ErrorCovariance {
 public:
  static constexpr int kPaddedSize = 28;  // even, so that columns consist of whole SIMD vectors
  using Columns = double[3][kPaddedSize];

  ErrorCovariance();

  double operator()(int i, int j) const noexcept { return i < j ? P_[i][j] : P_[j][i]; }
  /// Set `count` variances from index `first` on, and the covariances of these errors to zero.
  void set_variance(int first, int count, double variance) noexcept;
  void add_variance(int first, int count, double variance) noexcept;

  /// Propagate over one tick: P = Phi P Phi' + Q.
  void propagate(const ErrorPropagation& motion) noexcept;

  /// Compute P H' for the measurement of a foot, H xi = xi_p - xi_d + xi_R x lever.
  /// @param lever [m] world axes @param out shape (kSize, 3), by columns
  void project(int leg, const Vector3& lever, Columns& out) const noexcept;

  /// Update with a measurement z = H xi + noise of variance R, in the expanded Joseph form:
  /// (I - K H) P (I - K H)' + K R K' = P - K M' - M K', with M = W - K S / 2, W = P H',
  /// S = H P H' + R. The result is symmetric, and correct also for an inexact gain K.
  void correct(const Columns& W, const Columns& K, const Matrix3& S) noexcept;

 private:
  void multiply_transition(const ErrorPropagation& motion) noexcept;
  void fill_upper_triangle() noexcept;
  void transpose() noexcept;

  alignas(16) double P_[kPaddedSize][kPaddedSize];  // by columns
};

}  // namespace surefoot
