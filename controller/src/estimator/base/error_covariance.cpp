// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/base/error_covariance.hpp"

#include <utility>

namespace surefoot {

using namespace error;

ErrorCovariance::ErrorCovariance() : P_{} {}

void ErrorCovariance::set_variance(int first, int count, double variance) noexcept {
  for (int k = first; k < first + count; ++k) {
    for (int i = 0; i < kPadded; ++i) (i < k ? P_[i][k] : P_[k][i]) = 0.0;
    P_[k][k] = variance;
  }
}

void ErrorCovariance::add_variance(int first, int count, double variance) noexcept {
  for (int k = first; k < first + count; ++k) P_[k][k] += variance;
}

void ErrorCovariance::mirror() noexcept {
  for (int j = 1; j < kPadded; ++j) {
    for (int i = 0; i < j; ++i) P_[j][i] = P_[i][j];
  }
}

void ErrorCovariance::transpose() noexcept {
  for (int j = 1; j < kPadded; ++j) {
    for (int i = 0; i < j; ++i) std::swap(P_[j][i], P_[i][j]);
  }
}

// P Phi', column by column; those that others still need come last.
void ErrorCovariance::multiply(const ErrorMotion& motion) noexcept {
  const double dt = motion.dt, turned = kGravity * dt;
  const double* const gyroscope[] = {P_[kGyroscope], P_[kGyroscope + 1], P_[kGyroscope + 2]};
  for (int k = 0; k < 3; ++k) {
    double* const p = P_[kPosition + k];
    const double* const v = P_[kVelocity + k];
    for (int i = 0; i < kPadded; ++i) p[i] += dt * v[i];
  }
  // Gravity turned by the error of rotation: g x xi, g along -z.
  for (int i = 0; i < kPadded; ++i) {
    P_[kVelocity][i] += turned * P_[kRotation + 1][i];
    P_[kVelocity + 1][i] -= turned * P_[kRotation][i];
  }
  for (int k = 0; k < 3; ++k) {
    double* const v = P_[kVelocity + k];
    const double a = motion.by_force(k, 0), b = motion.by_force(k, 1), c = motion.by_force(k, 2);
    for (int i = 0; i < kPadded; ++i) {
      v[i] -=
          a * P_[kAccelerometer][i] + b * P_[kAccelerometer + 1][i] + c * P_[kAccelerometer + 2][i];
    }
  }
  for (int k = 0; k < kGroup; ++k) {
    double* const column = P_[k];
    const double a = motion.by_rate(k, 0), b = motion.by_rate(k, 1), c = motion.by_rate(k, 2);
    for (int i = 0; i < kPadded; ++i) {
      column[i] -= a * gyroscope[0][i] + b * gyroscope[1][i] + c * gyroscope[2][i];
    }
  }
  for (int k = kAccelerometer; k < kAccelerometer + 3; ++k) {
    for (int i = 0; i < kPadded; ++i) P_[k][i] *= motion.accelerometer_kept;
  }
}

// A noisy rate does to the group what an error of the gyroscope's bias does, so its variance goes
// along as the bias's own, and what that says of the bias is taken back.
void ErrorCovariance::propagate(const ErrorMotion& motion) noexcept {
  mirror();
  for (int k = 0; k < 3; ++k) P_[kGyroscope + k][kGyroscope + k] += motion.rate_variance;
  multiply(motion);
  transpose();
  multiply(motion);
  for (int k = 0; k < kGroup; ++k) {
    for (int j = 0; j < 3; ++j)
      P_[k][kGyroscope + j] += motion.rate_variance * motion.by_rate(k, j);
  }
  for (int k = 0; k < 3; ++k) P_[kGyroscope + k][kGyroscope + k] -= motion.rate_variance;

  add_variance(kVelocity, 3, motion.dt * motion.dt * motion.force_variance);
  for (int leg = 0; leg < kLegs; ++leg) {
    add_variance(kFeet + 3 * leg, 3, motion.foot_variance[leg]);
  }
  add_variance(kGyroscope, 3, motion.gyroscope_drift);
  add_variance(kAccelerometer, 3, motion.accelerometer_drift);
  for (int k = 0; k < 3; ++k) {
    for (int i = k; i < 3; ++i)
      P_[kAccelerometer + k][kAccelerometer + i] +=
          motion.vertical_drift * motion.up_base[k] * motion.up_base[i];
  }
}

void ErrorCovariance::project(int leg, const Vector3& lever, Columns& out) const noexcept {
  for (int k = 0; k < 3; ++k) {
    const int p = kPosition + k, d = kFeet + 3 * leg + k;
    for (int i = 0; i < p; ++i) out[k][i] = P_[i][p] - P_[i][d];
    for (int i = p; i < d; ++i) out[k][i] = P_[p][i] - P_[i][d];
    for (int i = d; i < kPadded; ++i) out[k][i] = P_[p][i] - P_[d][i];
  }
  for (int i = 0; i < kPadded; ++i) {
    Vector3 turn;  // the i-th row of the rotation's columns
    for (int j = 0; j < 3; ++j) turn[j] = i >= j ? P_[kRotation + j][i] : P_[i][kRotation + j];
    const Vector3 moved = turn.cross(lever);
    for (int k = 0; k < 3; ++k) out[k][i] += moved[k];
  }
}

void ErrorCovariance::correct(const Columns& W, const Columns& K, const Matrix3& S) noexcept {
  Columns M;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < kPadded; ++i) {
      M[k][i] = W[k][i] - 0.5 * (K[0][i] * S(0, k) + K[1][i] * S(1, k) + K[2][i] * S(2, k));
    }
  }
  for (int j = 0; j < kSize; ++j) {
    const double k0 = K[0][j], k1 = K[1][j], k2 = K[2][j];
    const double m0 = M[0][j], m1 = M[1][j], m2 = M[2][j];
    double* const column = P_[j];
    for (int i = j & ~1; i < kPadded; ++i) {
      column[i] -=
          K[0][i] * m0 + K[1][i] * m1 + K[2][i] * m2 + M[0][i] * k0 + M[1][i] * k1 + M[2][i] * k2;
    }
  }
}

}  // namespace surefoot
