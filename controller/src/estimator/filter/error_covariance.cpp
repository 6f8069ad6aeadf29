// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/filter/error_covariance.hpp"

#include <utility>

namespace surefoot {

using namespace error_index;

ErrorCovariance::ErrorCovariance() : P_{} {}

void ErrorCovariance::set_variance(int first, int count, double variance) noexcept {
  for (int k = first; k < first + count; ++k) {
    for (int i = 0; i < kPaddedSize; ++i) (i < k ? P_[i][k] : P_[k][i]) = 0.0;
    P_[k][k] = variance;
  }
}

void ErrorCovariance::add_variance(int first, int count, double variance) noexcept {
  for (int k = first; k < first + count; ++k) P_[k][k] += variance;
}

void ErrorCovariance::fill_upper_triangle() noexcept {
  for (int j = 1; j < kPaddedSize; ++j) {
    for (int i = 0; i < j; ++i) P_[j][i] = P_[i][j];
  }
}

void ErrorCovariance::transpose() noexcept {
  for (int j = 1; j < kPaddedSize; ++j) {
    for (int i = 0; i < j; ++i) std::swap(P_[j][i], P_[i][j]);
  }
}

// Compute P Phi^T in place, column by column. A column is changed only after it has been used for
// all other columns that depend on its old value.
void ErrorCovariance::multiply_transition(const ErrorPropagation& motion) noexcept {
  const double dt = motion.dt, gravity_dt = kGravity * dt;
  const double* const gyroscope[] = {P_[kGyroscopeBias], P_[kGyroscopeBias + 1],
                                     P_[kGyroscopeBias + 2]};
  for (int k = 0; k < 3; ++k) {
    double* const p = P_[kPosition + k];
    const double* const v = P_[kVelocity + k];
    for (int i = 0; i < kPaddedSize; ++i) p[i] += dt * v[i];
  }
  // Effect of the rotation error on the velocity: g x xi_R, with gravity g along -z.
  for (int i = 0; i < kPaddedSize; ++i) {
    P_[kVelocity][i] += gravity_dt * P_[kRotation + 1][i];
    P_[kVelocity + 1][i] -= gravity_dt * P_[kRotation][i];
  }
  for (int k = 0; k < 3; ++k) {
    double* const v = P_[kVelocity + k];
    const double a = motion.force_jacobian(k, 0), b = motion.force_jacobian(k, 1),
                 c = motion.force_jacobian(k, 2);
    for (int i = 0; i < kPaddedSize; ++i) {
      v[i] -= a * P_[kAccelerometerBias][i] + b * P_[kAccelerometerBias + 1][i] +
              c * P_[kAccelerometerBias + 2][i];
    }
  }
  for (int k = 0; k < kGroupSize; ++k) {
    double* const column = P_[k];
    const double a = motion.rate_jacobian(k, 0), b = motion.rate_jacobian(k, 1),
                 c = motion.rate_jacobian(k, 2);
    for (int i = 0; i < kPaddedSize; ++i) {
      column[i] -= a * gyroscope[0][i] + b * gyroscope[1][i] + c * gyroscope[2][i];
    }
  }
  for (int k = kAccelerometerBias; k < kAccelerometerBias + 3; ++k) {
    for (int i = 0; i < kPaddedSize; ++i) P_[k][i] *= motion.accelerometer_bias_decay;
  }
}

// Gyroscope noise affects the error on the group exactly as an error of the gyroscope bias does. So
// the variance of this noise is added to the variance of the bias before the propagation.
// Afterwards the effect of the noise on the rows and columns of the bias is removed.
void ErrorCovariance::propagate(const ErrorPropagation& motion) noexcept {
  fill_upper_triangle();
  for (int k = 0; k < 3; ++k) P_[kGyroscopeBias + k][kGyroscopeBias + k] += motion.rate_variance;
  multiply_transition(motion);
  transpose();
  multiply_transition(motion);
  for (int k = 0; k < kGroupSize; ++k) {
    for (int j = 0; j < 3; ++j)
      P_[k][kGyroscopeBias + j] += motion.rate_variance * motion.rate_jacobian(k, j);
  }
  for (int k = 0; k < 3; ++k) P_[kGyroscopeBias + k][kGyroscopeBias + k] -= motion.rate_variance;

  add_variance(kVelocity, 3, motion.dt * motion.dt * motion.force_variance);
  for (int leg = 0; leg < kLegs; ++leg) {
    add_variance(kFeet + 3 * leg, 3, motion.foot_variance[leg]);
  }
  add_variance(kGyroscopeBias, 3, motion.gyroscope_drift_variance);
  add_variance(kAccelerometerBias, 3, motion.accelerometer_drift_variance);
  P_[kSole][kSole] += motion.sole_drift_variance;
  for (int k = 0; k < 3; ++k) {
    for (int i = k; i < 3; ++i)
      P_[kAccelerometerBias + k][kAccelerometerBias + i] +=
          motion.vertical_drift_variance * motion.up_base[k] * motion.up_base[i];
  }
}

void ErrorCovariance::project(int leg, const Vector3& lever, const Vector3& load,
                              Columns& out) const noexcept {
  for (int k = 0; k < 3; ++k) {
    const int p = kPosition + k, d = kFeet + 3 * leg + k;
    for (int i = 0; i < p; ++i) out[k][i] = P_[i][p] - P_[i][d];
    for (int i = p; i < d; ++i) out[k][i] = P_[p][i] - P_[i][d];
    for (int i = d; i < kPaddedSize; ++i) out[k][i] = P_[p][i] - P_[d][i];
  }
  for (int i = 0; i < kPaddedSize; ++i) {
    Vector3 turn;  // entries of row i in the three rotation columns
    for (int j = 0; j < 3; ++j) turn[j] = i >= j ? P_[kRotation + j][i] : P_[i][kRotation + j];
    const Vector3 moved = turn.cross(lever);
    const double sole = P_[i][kSole];
    for (int k = 0; k < 3; ++k) out[k][i] += moved[k] + sole * load[k];
  }
}

void ErrorCovariance::project_velocity(Columns& out) const noexcept {
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < kPaddedSize; ++i) out[k][i] = (*this)(i, kVelocity + k);
  }
}

void ErrorCovariance::correct(const Columns& W, const Columns& K, const Matrix3& S) noexcept {
  Columns M;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < kPaddedSize; ++i) {
      M[k][i] = W[k][i] - 0.5 * (K[0][i] * S(0, k) + K[1][i] * S(1, k) + K[2][i] * S(2, k));
    }
  }
  for (int j = 0; j < kSize; ++j) {
    const double k0 = K[0][j], k1 = K[1][j], k2 = K[2][j];
    const double m0 = M[0][j], m1 = M[1][j], m2 = M[2][j];
    double* const column = P_[j];
    for (int i = j & ~1; i < kPaddedSize; ++i) {
      column[i] -=
          K[0][i] * m0 + K[1][i] * m1 + K[2][i] * m2 + M[0][i] * k0 + M[1][i] * k1 + M[2][i] * k2;
    }
  }
}

}  // namespace surefoot
