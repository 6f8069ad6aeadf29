// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/filter/invariant_filter.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace surefoot {

using namespace error_index;

namespace {
// [m^2] Variance that keeps the innovation covariance invertible. Numerical: smaller than 4e-12,
// the square of kMinSigma in foot_noise.cpp.
constexpr double kMinFootVariance = 1e-12;
// The estimate is implausible if a variance is more negative than this, in its own unit. Numerical:
// rounding errors make zero variances slightly negative.
constexpr double kVarianceTolerance = 1e-6;
// The estimate is implausible above these values. Chosen: no robot is as fast, and the limits of
// the biases are about a tenth and a fifth of the sensors' full scale (35 rad/s, 157 m/s^2).
constexpr double kMaxSpeed = 20.0;              // [m/s]
constexpr double kMaxGyroscopeBias = 3.0;       // [rad/s]
constexpr double kMaxAccelerometerBias = 30.0;  // [m/s^2]
// [rad] A linearisation point is renewed after a rotation by this angle. Chosen. If smaller: the
// noise of the estimate renews the point at rest, and then the tilt drifts (see relinearise();
// test: test_estimator_rest.cpp). If larger: the error of the linearisation grows.
constexpr double kRelinearisationAngle = 0.01;

double square(double x) noexcept { return x * x; }

// Set decay and process noise of the accelerometer bias. The bias is a first-order Gauss-Markov
// process. The gain accelerometer_drift sets its random walk, and start_accelerometer_bias its
// stationary standard deviation. At rest a horizontal bias cannot be distinguished from a tilt. If
// the bias were a pure random walk, bias and tilt would drift together for ever.
void discretise_accelerometer_bias(const Gains& gains, ErrorPropagation& motion) noexcept {
  const double stationary_variance = square(gains.start_accelerometer_bias);
  const double rate = 0.5 * square(gains.accelerometer_drift) / stationary_variance;
  motion.accelerometer_bias_decay = std::exp(-motion.dt * rate);
  motion.accelerometer_drift_variance = -stationary_variance * std::expm1(-2.0 * motion.dt * rate);
}

// Compute column k of the gain K = W S^-1, and add the correction by component k of the innovation.
void correct_by(int k, double innovation, const ErrorCovariance::Columns& W, const Matrix3& inverse,
                ErrorCovariance::Columns& K,
                Eigen::Matrix<double, ErrorCovariance::kPaddedSize, 1>& xi) noexcept {
  for (int i = 0; i < ErrorCovariance::kPaddedSize; ++i) {
    K[k][i] = W[0][i] * inverse(0, k) + W[1][i] * inverse(1, k) + W[2][i] * inverse(2, k);
    xi[i] += K[k][i] * innovation;
  }
}

}  // namespace

void InvariantFilter::reset(const Quaternion& R, const Vector3& v, const Vector3& p,
                            const FeetMatrix& p_feet, const InitialSigmas& sigmas) noexcept {
  *this = InvariantFilter();
  q_ = R;
  R_linearisation_ = R_ = R.toRotationMatrix();
  v_ = v;
  p_ = p;
  feet_ = p_feet;
  this->reset_covariance(sigmas);
}

void InvariantFilter::reset_covariance(const InitialSigmas& sigmas) noexcept {
  P_ = ErrorCovariance();
  P_.set_variance(kRotation, 2, square(sigmas.tilt));
  P_.set_variance(kVelocity, 3, square(sigmas.velocity));
  P_.set_variance(kFeet, 3 * kLegs, square(sigmas.foot));
  P_.set_variance(kGyroscopeBias, 3, square(sigmas.gyroscope));
  P_.set_variance(kAccelerometerBias, 3, square(sigmas.accelerometer));
  P_.set_variance(kSole, 1, square(sigmas.sole));
}

void InvariantFilter::set_attitude(const Quaternion& R, const Vector3& gyroscope_bias,
                                   const Vector3& accelerometer_bias,
                                   double velocity_sigma) noexcept {
  q_ = R;
  R_ = R.toRotationMatrix();
  gyroscope_bias_ = gyroscope_bias;
  accelerometer_bias_ = accelerometer_bias;
  v_.setZero();
  P_.set_variance(kVelocity, 3, square(velocity_sigma));
}

bool InvariantFilter::is_plausible() const noexcept {
  const bool values_plausible = v_.norm() < kMaxSpeed &&
                                gyroscope_bias_.norm() < kMaxGyroscopeBias &&
                                accelerometer_bias_.norm() < kMaxAccelerometerBias;
  bool variances_plausible = true;  // NaN fails every comparison
  for (int k = 0; k < kSize; ++k)
    variances_plausible = variances_plausible && P_(k, k) > -kVarianceTolerance;
  return values_plausible && variances_plausible;
}

// Choose the attitude at which the effect of the biases on the error is linearised. The filter
// keeps this attitude until the body has rotated by kRelinearisationAngle.
//
// At rest a horizontal bias and a tilt cannot be distinguished. If the filter linearised at each
// new estimate, the Jacobian would vary with the noise of the estimate and would be correlated with
// the innovations. The filter would then wrongly treat tilt and bias as separately observable, and
// the bias of a robot at rest would drift by 0.16 m/s^2 per hour. This is the inconsistency by
// linearisation that Huang, Mourikis, Roumeliotis 2010 describe ("Observability-based rules for
// designing consistent EKF SLAM estimators").
void InvariantFilter::relinearise() noexcept {
  // For a small angle a between attitudes R_1 and R_2: |R_1 - R_2|^2 = 2 a^2.
  if ((R_ - R_linearisation_).squaredNorm() > 2.0 * square(kRelinearisationAngle))
    R_linearisation_ = R_;
}

// Choose the lever at which the measurement is linearised. The filter keeps this lever until the
// lever has rotated by kRelinearisationAngle. The ground normal comes from the estimated feet and
// has their noise: if the filter linearised at each new lever, the bias of a standing robot would
// drift by 0.016 m/s^2 per hour.
void InvariantFilter::relinearise(const Vector3& lever) noexcept {
  const double max_squared_change = square(kRelinearisationAngle) * lever.squaredNorm();
  if ((lever - lever_linearisation_).squaredNorm() > max_squared_change)
    lever_linearisation_ = lever;
}

void InvariantFilter::predict(const Gains& gains, const ImuInput& imu,
                              const Eigen::Vector4d& foot_variance, double sole_variance) noexcept {
  const double dt = imu.dt;
  ErrorPropagation motion;
  motion.dt = dt;
  relinearise();
  motion.force_jacobian = dt * R_linearisation_;
  motion.rate_jacobian.middleRows<3>(kRotation) = motion.force_jacobian;
  motion.rate_jacobian.middleRows<3>(kVelocity) = skew(v_) * motion.force_jacobian;
  motion.rate_jacobian.middleRows<3>(kPosition) = skew(p_) * motion.force_jacobian;
  for (int leg = 0; leg < kLegs; ++leg) {
    motion.rate_jacobian.middleRows<3>(kFeet + 3 * leg) =
        skew(feet_.col(leg)) * motion.force_jacobian;
  }
  motion.rate_variance = imu.w_variance;
  motion.force_variance = imu.f_variance;
  motion.foot_variance = foot_variance;
  motion.sole_drift_variance = sole_variance;
  motion.gyroscope_drift_variance = square(gains.gyroscope_drift) * dt;
  discretise_accelerometer_bias(gains, motion);
  // Stance feet make the vertical bias observable, so this component gets more process noise. With
  // little process noise, the filter would attribute a jump of the vertical bias to the horizontal
  // bias and the tilt: a jump of 0.7 m/s^2 could then make an a1 tip over. The time constant with
  // which the filter estimates the vertical bias is sigma sqrt(dt) / accelerometer_drift_vertical,
  // where sigma is the standard deviation of the accelerometer.
  motion.up_base = R_linearisation_.row(2);
  motion.vertical_drift_variance = square(gains.accelerometer_drift_vertical) * dt;
  P_.propagate(motion);

  // Rotate the specific force by half of the rotation in this tick, which gives its mean over the
  // tick.
  const Vector3 turn = dt * (imu.w_base - gyroscope_bias_);
  const Vector3 force = imu.f_base - accelerometer_bias_;
  const Vector3 a = R_ * (force + 0.5 * turn.cross(force)) - kGravity * Vector3::UnitZ();
  p_ += dt * v_ + 0.5 * dt * dt * a;
  v_ += dt * a;
  accelerometer_bias_ *= motion.accelerometer_bias_decay;
  q_ = (q_ * exp_so3(turn)).normalized();
  R_ = q_.toRotationMatrix();
}

void InvariantFilter::correct(const FeetInput& feet, double gate) noexcept {
  relinearise(feet.lever);
  Error xi = Error::Zero();
  nis_ = 0.0;
  nis_dimension_ = 0;
  const FeetMatrix z = R_ * feet.y_base + sole_compliance_ * feet.normal * feet.load.transpose() -
                       (feet_.colwise() - p_);
  for (int leg = 0; leg < kLegs; ++leg) correct_foot(leg, z.col(leg), feet, gate, xi);
  apply(xi);
}

// Add the correction by one foot to xi. The innovation is z = R y + sole_compliance load - (d - p).
// To first order it is xi_p - xi_d + xi_R x lever + xi_sole load, independent of the state. The
// third term exists because y is the contact point of a spherical foot. Its position relative to
// the centre of the foot depends on the ground normal in base axes, and so on the estimated
// attitude. All feet share one linearisation point, so the corrections by the feet with lower index
// are subtracted from the innovation.
//
// The load at rest contains errors that do not move the foot, so the sole compliance is corrected
// only while the load changes. At other times its gain is zero (Schmidt's consider filter). While
// the robot stands, its error is left out too: with a load that varies, the position, which is not
// observable, would seem to be.
void InvariantFilter::correct_foot(int leg, const Vector3& z, const FeetInput& feet, double gate,
                                   Error& xi) noexcept {
  const int foot = kFeet + 3 * leg;
  const bool uncertain_sink = feet.steps || feet.load_changes[leg];
  const Vector3 load = uncertain_sink ? Vector3(feet.load[leg] * feet.normal) : Vector3::Zero();
  const Vector3& lever = lever_linearisation_;
  ErrorCovariance::Columns W, K;
  P_.project(leg, lever, load, W);
  Matrix3 S;
  for (int k = 0; k < 3; ++k) {
    const Vector3 turn(W[k][kRotation], W[k][kRotation + 1], W[k][kRotation + 2]);
    const Vector3 moved = turn.cross(lever);
    for (int i = 0; i < 3; ++i)
      S(i, k) = W[k][kPosition + i] - W[k][foot + i] + moved[i] + W[k][kSole] * load[i];
  }
  predicted_variance_[leg] = S.trace() / 3.0;
  S.diagonal().array() += feet.variance[leg] + kMinFootVariance;
  S += feet.normal_variance[leg] * feet.normal * feet.normal.transpose();
  const Vector3 predicted = xi.segment<3>(kPosition) - xi.segment<3>(foot) +
                            Vector3(xi.segment<3>(kRotation)).cross(lever) + xi[kSole] * load;
  const Vector3 innovation = z - predicted;
  Matrix3 inverse = S.inverse();
  const double nis = innovation.dot(inverse * innovation);
  const double gate_ratio = nis / (gate * gate);
  foot_nis_[leg] = nis;
  rejected_feet_[leg] = !(gate_ratio <= kRejectionRatio * kRejectionRatio);
  if (rejected_feet_[leg]) return;
  if (gate_ratio > 1.0) {
    const double excess = (gate_ratio - 1.0) * S.trace() / 3.0;
    if (feet.slides[leg]) {
      // The foot has moved. If its position stayed where it was, it would pull the base along in
      // every tick in which it slides.
      P_.add_variance(foot, 3, excess);
      for (int k = 0; k < 3; ++k) W[k][foot + k] -= excess;
    }
    S.diagonal().array() += excess;
    inverse = S.inverse();
  }
  nis_ += nis;
  nis_dimension_ += 3;
  for (int k = 0; k < 3; ++k) {
    correct_by(k, innovation[k], W, inverse, K, xi);
    if (!feet.load_changes[leg]) {
      xi[kSole] -= K[k][kSole] * innovation[k];
      K[k][kSole] = 0.0;
    }
  }
  P_.correct(W, K, S);
}

// The innovation is z = v_estimate - 0 = xi_v, to first order and for a measured velocity of zero.
void InvariantFilter::correct_zero_velocity(double variance) noexcept {
  ErrorCovariance::Columns W, K;
  P_.project_velocity(W);
  Matrix3 S;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) S(i, k) = W[k][kVelocity + i];
  S.diagonal().array() += variance;
  const Matrix3 inverse = S.inverse();
  Error xi = Error::Zero();
  for (int k = 0; k < 3; ++k) correct_by(k, v_[k], W, inverse, K, xi);
  P_.correct(W, K, S);
  apply(xi);
}

// Apply the correction xi. On the group: X_next = exp(-xi) X. Biases: subtract xi.
void InvariantFilter::apply(const Error& xi) noexcept {
  const Vector3 turn = -xi.segment<3>(kRotation);
  const Quaternion dq = exp_so3(turn);
  const Matrix3 dR = dq.toRotationMatrix(), cross = skew(turn);
  // Left Jacobian of the rotation, to second order.
  const Matrix3 J = Matrix3::Identity() + 0.5 * cross + cross * cross / 6.0;
  q_ = (dq * q_).normalized();
  R_ = q_.toRotationMatrix();
  v_ = dR * v_ - J * xi.segment<3>(kVelocity);
  p_ = dR * p_ - J * xi.segment<3>(kPosition);
  for (int leg = 0; leg < kLegs; ++leg) {
    feet_.col(leg) = dR * feet_.col(leg) - J * xi.segment<3>(kFeet + 3 * leg);
  }
  gyroscope_bias_ -= xi.segment<3>(kGyroscopeBias);
  accelerometer_bias_ -= xi.segment<3>(kAccelerometerBias);
  sole_compliance_ = std::max(sole_compliance_ - xi[kSole], 0.0);
}

}  // namespace surefoot
