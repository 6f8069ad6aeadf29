// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/base/invariant_filter.hpp"

#include <Eigen/LU>
#include <cmath>

namespace surefoot {

using namespace error;

namespace {
constexpr double kSmallestFoot = 1e-12;  // [m^2] keeps a perfectly known foot invertible
constexpr double kRounding = 1e-6;       // of a variance of nothing
constexpr double kMostSpeed = 20.0;      // [m/s]
constexpr double kMostRateBias = 3.0;    // [rad/s]
constexpr double kMostForceBias = 30.0;  // [m/s^2]
constexpr double kTurned = 0.01;         // [rad] after which linearisations are made anew

double square(double x) noexcept { return x * x; }

// The accelerometer's bias is a first-order Gauss-Markov process that wanders as its gain says and
// is as great in the long run as it was thought to be at the start. At rest nothing tells it from a
// tilt, and without a bound both would walk together for ever.
void move_accelerometer_bias(const Gains& gains, ErrorMotion& motion) noexcept {
  const double start = square(gains.start_accelerometer_bias);
  const double rate = 0.5 * square(gains.accelerometer_drift) / start;
  motion.accelerometer_kept = std::exp(-motion.dt * rate);
  motion.accelerometer_drift = -start * std::expm1(-2.0 * motion.dt * rate);
}

}  // namespace

void InvariantFilter::reset(const Quaternion& R, const Vector3& v, const Vector3& p,
                            const FeetMatrix& p_feet, const StartDoubt& doubt) noexcept {
  *this = InvariantFilter();
  q_ = R;
  linear_ = R_ = R.toRotationMatrix();
  v_ = v;
  p_ = p;
  feet_ = p_feet;
  this->doubt(doubt);
}

void InvariantFilter::doubt(const StartDoubt& doubt) noexcept {
  P_ = ErrorCovariance();
  P_.set_variance(kRotation, 2, square(doubt.tilt));
  P_.set_variance(kVelocity, 3, square(doubt.velocity));
  P_.set_variance(kFeet, 3 * kLegs, square(doubt.foot));
  P_.set_variance(kGyroscope, 3, square(doubt.gyroscope));
  P_.set_variance(kAccelerometer, 3, square(doubt.accelerometer));
}

bool InvariantFilter::possible() const noexcept {
  const bool values = v_.norm() < kMostSpeed && gyroscope_bias_.norm() < kMostRateBias &&
                      accelerometer_bias_.norm() < kMostForceBias;
  bool variances = true;  // what is no number is none
  for (int k = 0; k < kSize; ++k) variances = variances && P_(k, k) > -kRounding;
  return values && variances;
}

// What the biases do to the error turns with the attitude. Were it made at each tick's estimate,
// the estimate's own noise would turn it from tick to tick, always with the innovations that it
// came from: the filter would believe that it sees the tilt that a bias looks like, and learn both,
// steadily wrong, by 0.16 m/s^2 an hour on a robot at rest. (Inconsistency by linearisation: Huang,
// Mourikis, Roumeliotis 2010, "Observability-based rules for designing consistent EKF SLAM
// estimators".) So the attitude it is made at is kept until the body has turned.
void InvariantFilter::relinearise() noexcept {
  // |R - R'|^2 of two attitudes a small angle apart is twice the angle's square.
  if ((R_ - linear_).squaredNorm() > 2.0 * square(kTurned)) linear_ = R_;
}

// The same of the measurement's lever, until the lever itself has turned: the ground's normal is
// found from the believed feet and trembles with them. Taken as it came, it taught a robot that
// stands 0.016 m/s^2 of bias an hour.
void InvariantFilter::relinearise(const Vector3& lever) noexcept {
  const double most = square(kTurned) * lever.squaredNorm();
  if ((lever - linear_lever_).squaredNorm() > most) linear_lever_ = lever;
}

void InvariantFilter::predict(const Gains& gains, const InertialStep& imu,
                              const Eigen::Vector4d& foot_variance) noexcept {
  const double dt = imu.dt;
  ErrorMotion motion;
  motion.dt = dt;
  relinearise();
  motion.by_force = dt * linear_;
  motion.by_rate.middleRows<3>(kRotation) = motion.by_force;
  motion.by_rate.middleRows<3>(kVelocity) = skew(v_) * motion.by_force;
  motion.by_rate.middleRows<3>(kPosition) = skew(p_) * motion.by_force;
  for (int leg = 0; leg < kLegs; ++leg) {
    motion.by_rate.middleRows<3>(kFeet + 3 * leg) = skew(feet_.col(leg)) * motion.by_force;
  }
  motion.rate_variance = imu.w_variance;
  motion.force_variance = imu.f_variance;
  motion.foot_variance = foot_variance;
  motion.gyroscope_drift = square(gains.gyroscope_drift) * dt;
  move_accelerometer_bias(gains, motion);
  // Along the vertical standing feet tell the bias from everything else, so it may change soon.
  // Were it thought to be known, one that jumps would be laid to the horizontal bias and the tilt,
  // which are not: 0.7 m/s^2 upwards made an a1 rock itself off its feet. How soon it is learnt
  // goes by sigma sqrt(dt) / drift, with the accelerometer's noise sigma.
  motion.up_base = linear_.row(2);
  motion.vertical_drift = square(gains.accelerometer_drift_vertical) * dt;
  P_.propagate(motion);

  // The specific force is turned by half of the tick's rotation: its mean over the tick.
  const Vector3 turn = dt * (imu.w_base - gyroscope_bias_);
  const Vector3 force = imu.f_base - accelerometer_bias_;
  const Vector3 a = R_ * (force + 0.5 * turn.cross(force)) - kGravity * Vector3::UnitZ();
  p_ += dt * v_ + 0.5 * dt * dt * a;
  v_ += dt * a;
  accelerometer_bias_ *= motion.accelerometer_kept;
  q_ = (q_ * exp_so3(turn)).normalized();
  R_ = q_.toRotationMatrix();
}

void InvariantFilter::correct(const FeetMatrix& y_base, const Eigen::Vector4d& variance,
                              double gate, const Vector3& lever) noexcept {
  relinearise(lever);
  Error xi = Error::Zero();
  nis_ = 0.0;
  nis_dimension_ = 0;
  const FeetMatrix z = R_ * y_base - (feet_.colwise() - p_);
  for (int leg = 0; leg < kLegs; ++leg) {
    correct_foot(leg, z.col(leg), variance[leg], gate, linear_lever_, xi);
  }
  apply(xi);
}

// z = R y - (d - p) = xi_p - xi_d + xi_R x lever, to first order and whatever the state: a round
// sole's contact point is straight below its centre, by the very attitude that is looked for. The
// feet share one point of linearisation: what those before have explained is taken off.
void InvariantFilter::correct_foot(int leg, const Vector3& z, double variance, double gate,
                                   const Vector3& lever, Error& xi) noexcept {
  const int foot = kFeet + 3 * leg;
  ErrorCovariance::Columns W, K;
  P_.project(leg, lever, W);
  Matrix3 S;
  for (int k = 0; k < 3; ++k) {
    const Vector3 turn(W[k][kRotation], W[k][kRotation + 1], W[k][kRotation + 2]);
    const Vector3 moved = turn.cross(lever);
    for (int i = 0; i < 3; ++i) S(i, k) = W[k][kPosition + i] - W[k][foot + i] + moved[i];
  }
  expected_[leg] = S.trace() / 3.0;
  S.diagonal().array() += variance + kSmallestFoot;
  const Vector3 explained = xi.segment<3>(kPosition) - xi.segment<3>(foot) +
                            Vector3(xi.segment<3>(kRotation)).cross(lever);
  const Vector3 innovation = z - explained;
  Matrix3 inverse = S.inverse();
  const double nis = innovation.dot(inverse * innovation);
  const double surprise = nis / (gate * gate);
  foot_nis_[leg] = nis;
  refused_[leg] = !(surprise <= kRefuse * kRefuse);
  if (refused_[leg]) return;
  if (surprise > 1.0) {
    S.diagonal().array() += (surprise - 1.0) * S.trace() / 3.0;
    inverse = S.inverse();
  }
  nis_ += nis;
  nis_dimension_ += 3;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < ErrorCovariance::kPadded; ++i) {
      K[k][i] = W[0][i] * inverse(0, k) + W[1][i] * inverse(1, k) + W[2][i] * inverse(2, k);
      xi[i] += K[k][i] * innovation[k];
    }
  }
  P_.correct(W, K, S);
}

// X = exp(-xi) X.
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
  gyroscope_bias_ -= xi.segment<3>(kGyroscope);
  accelerometer_bias_ -= xi.segment<3>(kAccelerometer);
}

}  // namespace surefoot
