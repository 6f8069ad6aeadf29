// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/joint_regression.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// All values are chosen. Test: test_joint_estimate.cpp, test_learnt_joints.py.
// [tau_max] Standard deviation of the torque of one sample: torque sensor, wrong masses of the leg
// and the shocks of other feet.
constexpr double kTorqueSigma = 0.02;
// [s] Time for which the error of the torque is the same, a part of a swing. Samples of one such
// time count as one.
constexpr double kCorrelationTime = 0.04;
// [tau_max] Standard deviation of the part of the torque error that does not average out.
constexpr double kModelSigma = 0.005;
// [s] Time over which the memory fades to 1/e, summed over all joints of the kind. Friction changes
// when a gear warms up.
constexpr double kMemoryTime = 10.0;
// Standard deviations beyond which a sample does not count: the foot has hit something.
constexpr double kMaxDeviations = 3.0;
// Initial standard deviations beyond which no result lies.
constexpr double kMaxSigmas = 3.0;

}  // namespace

JointRegression::JointRegression(double tau_max, const Vector3& sigmas)
    : tau_max_(tau_max),
      initial_variances_(sigmas.cwiseAbs2()),
      P_(initial_variances_.asDiagonal()) {}

void JointRegression::learn(const Vector3& regressor, double torque, double dt) noexcept {
  // The memory fades even if the sample does not count, so that no wrong estimate stays for ever.
  // No variance grows beyond its initial value.
  if ((P_.diagonal().array() < initial_variances_.array()).all()) P_ *= 1.0 + dt / kMemoryTime;
  const Vector3 gain = P_ * regressor;
  const double sigma = kTorqueSigma * tau_max_;
  const double expected = regressor.dot(gain);
  const double innovation = torque - regressor.dot(x_);
  if (std::abs(innovation) > kMaxDeviations * std::sqrt(expected + sigma * sigma)) return;
  const double variance = expected + sigma * sigma * std::max(1.0, kCorrelationTime / dt);
  x_ += innovation / variance * gain;
  P_ -= gain * gain.transpose() / variance;
  time_ = std::min(time_ + dt, kMemoryTime);
  excitation_ += std::min(dt / time_, 1.0) * (regressor * regressor.transpose() - excitation_);
}

Vector3 JointRegression::result() const noexcept {
  const double sigma = kModelSigma * tau_max_;
  Matrix3 information = excitation_;
  information.diagonal() += sigma * sigma * initial_variances_.cwiseInverse();
  const Vector3 limit = kMaxSigmas * initial_variances_.cwiseSqrt();
  return (information.inverse() * (excitation_ * x_)).cwiseMax(-limit).cwiseMin(limit);
}

}  // namespace surefoot
