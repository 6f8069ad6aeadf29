// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/math.hpp"

namespace surefoot {

/// Where the parts of the filter's error stand.
namespace error_index {
constexpr int kRotation = 0;
constexpr int kVelocity = 3;
constexpr int kPosition = 6;
constexpr int kFeet = 9;  ///< three each
constexpr int kGyroscopeBias = 21;
constexpr int kAccelerometerBias = 24;
constexpr int kSize = 27;
constexpr int kGroupSize = kGyroscopeBias;  ///< what lies on the group; the biases follow
}  // namespace error_index

/// What the motion of one tick does to the error, xi' = Phi xi + noise.
struct ErrorPropagation {
  /// [R; v x R; p x R; d x R] dt: what a rate of turn adds to each part on the group.
  Eigen::Matrix<double, error_index::kGroupSize, 3> rate_jacobian;
  Matrix3 force_jacobian;                     ///< R dt: what a specific force adds to the velocity
  double dt = 0.0;                            ///< [s]
  double rate_variance = 0.0;                 ///< [rad^2/s^2] of the gyroscope over this tick
  double force_variance = 0.0;                ///< [m^2/s^4] of the accelerometer over this tick
  Eigen::Vector4d foot_variance;              ///< [m^2] that each foot may have moved
  double gyroscope_drift_variance = 0.0;      ///< [rad^2/s^2] of the bias, this tick
  double accelerometer_drift_variance = 0.0;  ///< [m^2/s^4]
  double accelerometer_bias_decay = 1.0;      ///< share of the bias that this tick does not forget
  Vector3 up_base = Vector3::UnitZ();         ///< the vertical, along which the bias
  double vertical_drift_variance = 0.0;       ///< [m^2/s^4] wanders this much more
};

/// Covariance of the filter's error. Its lower triangle is kept; mostly loops of constant length
/// over padded columns, because the two operations here are most of the estimator's time.
///
/// Real-time: yes.
class ErrorCovariance {
 public:
  static constexpr int kPaddedSize = 28;  // an even number of doubles: whole vectors
  using Columns = double[3][kPaddedSize];

  ErrorCovariance();

  double operator()(int i, int j) const noexcept { return i < j ? P_[i][j] : P_[j][i]; }
  void set_variance(int first, int count, double variance) noexcept;
  void add_variance(int first, int count, double variance) noexcept;

  /// P = Phi P Phi' + Q.
  void propagate(const ErrorPropagation& motion) noexcept;

  /// P H' of a foot, H xi = position less foot plus rotation x lever.
  /// @param lever [m] world axes @param out shape (kSize, 3), by columns
  void project(int leg, const Vector3& lever, Columns& out) const noexcept;

  /// Take in a measurement z = H xi of variance R, in Joseph's form multiplied out:
  /// (I - K H) P (I - K H)' + K R K' = P - K M' - M K', M = W - K S / 2, W = P H', which stays
  /// symmetric and right for a gain that is not exact.
  void correct(const Columns& W, const Columns& K, const Matrix3& S) noexcept;

 private:
  void multiply_transition(const ErrorPropagation& motion) noexcept;
  void fill_upper_triangle() noexcept;
  void transpose() noexcept;

  alignas(16) double P_[kPaddedSize][kPaddedSize];  // by columns
};

}  // namespace surefoot
