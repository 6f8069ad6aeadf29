// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/imu/imu_filter_input.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace surefoot {

namespace {

// [rad/s^2], [m/s^3] Assumed rates of change of gyroscope and accelerometer while the sensor
// repeats its last value. Chosen: over the 20 ms of a 50 Hz sensor the changes reach 1 rad/s
// (kUnmeasuredRateNoise) and 10 m/s^2 (1 g).
constexpr double kHeldRateDrift = 50.0;
constexpr double kHeldForceDrift = 500.0;
// [sigma^2] Squared change from one sample to the next above which the signal itself, and not only
// its noise, has changed. Derived: three times the mean squared change that noise alone causes on
// three axes (2 sigma^2 on each axis).
constexpr double kNoiseOnlyChange = 18.0;
// Standard deviation of the mean of a signal over a tick, as a share of the change of the signal in
// the tick. Chosen close to 1 / sqrt(12) = 0.29, the value if the mean can lie anywhere between the
// two samples with equal probability.
constexpr double kMeanUncertainty = 0.25;
// [rad/s] Standard deviations of a rate from the IMU quaternion, and of a rate from the legs.
// Chosen. Both are larger than noise_gyroscope (0.01), because these rates replace the gyroscope
// only when it fails. kLegRateNoise is larger, because feet slip. Test:
// frozen_gyroscope_is_replaced_by_quaternion_or_leg_rates.
constexpr double kQuaternionRateNoise = 0.05;
constexpr double kLegRateNoise = 0.2;
// [rad/s] A larger rate from the quaternion means that the quaternion has jumped. Derived: full
// scale of the gyroscope, 2000 deg/s.
constexpr double kMaxQuaternionRate = 35.0;
// The gyroscope is rejected if two conditions hold.
//
// [rad/s] Condition 1: the rates of gyroscope and legs differ by more than this. Chosen: five times
// kLegRateNoise, and smaller than 3 rad/s; an error of 3 rad/s for 0.1 s made a go1 fall
// (docs/explanation/estimator.md).
constexpr double kMinContradiction = 1.0;
// Condition 2: the rates of quaternion and legs differ by less than this share of the difference in
// condition 1. Chosen: the quaternion is then closer to the legs than to the gyroscope. Test:
// legs_and_quaternion_outvote_a_wrong_gyroscope.
constexpr double kAgreementRatio = 0.5;
// [rad/s], [m/s^2] Standard deviations of rate and specific force if nothing measures them and the
// body is assumed to be at rest: 1 rad/s and 0.3 g. Chosen larger than the motion of a standing
// body.
constexpr double kUnmeasuredRateNoise = 1.0;
constexpr double kUnmeasuredForceNoise = 3.0;
// Error of scale and axes of a gyroscope, as a share of the rate, and the time [s] for which a
// rotation in a hand lasts. Chosen: scale and axes of common MEMS gyroscopes are right to 1 %.
constexpr double kScaleError = 0.005;
constexpr double kScaleTime = 0.5;

double square(double x) noexcept { return x * x; }

// Compute the variance of a value that is used for the `age`-th time. All uses contain the same
// noise: the sum of n uses has the variance n^2 sigma^2, so the n-th use adds (2 n - 1) sigma^2.
// The second term accounts for the change of the signal since the value was measured; `change` is
// the assumed rate of change of the signal.
double held_variance(double sigma, int age, double change, double dt) noexcept {
  return (2.0 * age - 1.0) * square(sigma) + square(change * (age - 1) * dt);
}

// Compute the variance of the mean of a signal over a tick. Only the values at both ends of the
// tick are measured: a change beyond the noise may have happened early or late in the tick.
// `change` is the difference of these values.
double mean_variance(const Vector3& change, double sigma) noexcept {
  return square(kMeanUncertainty) *
         std::max(change.squaredNorm() - kNoiseOnlyChange * square(sigma), 0.0);
}

// Compute the variance of the error that scale and axes of the gyroscope cause. The error is no
// white noise: while the rotation lasts, it is the same in every tick.
double scale_variance(const Vector3& w_base, double dt) noexcept {
  return square(kScaleError) * w_base.squaredNorm() * 2.0 * kScaleTime / dt;
}

}  // namespace

ImuInput ImuFilterInput::update(const Gains& gains, const ImuReading& imu,
                                const InvariantFilter& filter, const Dynamics& dynamics,
                                const FeetState& feet, double dt) noexcept {
  ImuInput out;
  out.dt = dt;
  if (!started_) {
    last_w_ = imu.w_base;
    last_f_ = imu.f_base;
    w_noise_.reset(gains.noise_gyroscope);
    f_noise_.reset(gains.noise_accelerometer);
    started_ = true;
  }
  const bool quaternion_changed = imu.has_quaternion && has_last_quaternion_ &&
                                  imu.R_world_base.coeffs() != last_quaternion_.coeffs();
  quaternion_age_ += dt;
  gyroscope_rejected_ =
      imu.gyroscope == SensorVerdict::kGood &&
      contradicts_gyroscope(imu, filter, dynamics, feet.contact, quaternion_changed);
  if (imu.w_age == 1 && !gyroscope_rejected_ && feet.rest) w_noise_.update(imu.w_base, dt);
  if (imu.f_age == 1 && feet.rest) f_noise_.update(imu.f_base, dt);
  // A repeated value of the accelerometer has the same uncertainty as its first use.
  if (imu.f_age == 1) f_change_ = imu.f_base - last_f_;
  out.w_base = 0.5 * (imu.w_base + last_w_);
  out.f_base = 0.5 * (imu.f_base + last_f_);
  out.w_variance = held_variance(w_noise_.sigma(), imu.w_age, kHeldRateDrift, dt) +
                   // Steps vibrate in the gyroscope, and swing about zero. With this term, the
                   // feet, which slip and roll, would outweigh the gyroscope in yaw.
                   (feet.step ? 0.0 : mean_variance(imu.w_base - last_w_, w_noise_.sigma()));
  if (feet.off_ground) out.w_variance += scale_variance(out.w_base, dt);
  out.f_variance = held_variance(f_noise_.sigma(), imu.f_age, kHeldForceDrift, dt) +
                   mean_variance(f_change_, f_noise_.sigma());
  if (imu.gyroscope != SensorVerdict::kGood || gyroscope_rejected_) {
    replace_rate(imu, filter, dynamics, feet.contact, quaternion_changed, out);
  }
  if (imu.accelerometer != SensorVerdict::kGood) {
    out.f_base = filter.R_world_base().transpose() * (kGravity * Vector3::UnitZ()) +
                 filter.accelerometer_bias();
    out.f_variance = square(kUnmeasuredForceNoise);
  }
  last_w_ = gyroscope_rejected_ ? out.w_base : imu.w_base;
  last_f_ = imu.f_base;
  if (quaternion_changed || !has_last_quaternion_) quaternion_age_ = 0.0;
  rotation_since_last_ =
      quaternion_changed
          ? Quaternion::Identity()
          : rotation_since_last_ * exp_so3(dt * (out.w_base - filter.gyroscope_bias()));
  last_quaternion_ = imu.R_world_base;
  has_last_quaternion_ = imu.has_quaternion;
  return out;
}

// Return whether legs and IMU quaternion agree with each other but contradict the gyroscope. If
// feet slip or the body is hit, gyroscope and quaternion agree, so the result is false.
bool ImuFilterInput::contradicts_gyroscope(const ImuReading& imu, const InvariantFilter& filter,
                                           const Dynamics& dynamics, const Eigen::Vector4d& contact,
                                           bool quaternion_changed) const noexcept {
  if (!quaternion_changed && !gyroscope_rejected_) return false;  // legs alone do not suffice
  // With fewer than three stance feet, the last rate replaces the rate from the legs, because a
  // body cannot change its rate by kMinContradiction within one tick.
  Vector3 w_legs = last_w_ - filter.gyroscope_bias();
  rate_from_legs(dynamics, contact, w_legs);
  const double deviation = (imu.w_base - filter.gyroscope_bias() - w_legs).norm();
  if (!(deviation > kMinContradiction)) return false;
  if (!quaternion_changed) return true;  // the quaternion has no new value: keep the verdict
  const Vector3 w_quaternion =
      log_so3(last_quaternion_.conjugate() * imu.R_world_base) / quaternion_age_;
  return (w_quaternion - w_legs).norm() < kAgreementRatio * deviation;
}

void ImuFilterInput::replace_rate(const ImuReading& imu, const InvariantFilter& filter,
                                  const Dynamics& dynamics, const Eigen::Vector4d& contact,
                                  bool quaternion_changed, ImuInput& out) const noexcept {
  Vector3 w = Vector3::Zero();
  double sigma = kUnmeasuredRateNoise;
  // The robot may update the quaternion less often than it sends samples. Since the last update of
  // the quaternion, the filter has already applied rotation_since_last_. So only the rest of the
  // quaternion's rotation is attributed to this tick.
  if (quaternion_changed)
    w = log_so3(rotation_since_last_.conjugate() * last_quaternion_.conjugate() *
                imu.R_world_base) /
        out.dt;
  if (quaternion_changed && w.norm() < kMaxQuaternionRate) {
    sigma = kQuaternionRateNoise;
  } else if (w.setZero(); rate_from_legs(dynamics, contact, w)) {
    sigma = kLegRateNoise;
  }
  out.w_base = w + filter.gyroscope_bias();
  out.w_variance = square(sigma);
}

// Find the turn b with
// v_i - mean(v) = b x (p_i - mean(p)) by least squares.
bool turn_of_feet(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                  const FeetMatrix& motion, Vector3& turn) noexcept {
  Vector3 p_mean = Vector3::Zero(), v_mean = Vector3::Zero();
  int feet = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (contact[leg] < 0.5) continue;
    p_mean += dynamics.legs()[leg].p_world_contact;
    v_mean += motion.col(leg);
    ++feet;
  }
  if (feet < 3) return false;
  p_mean /= feet;
  v_mean /= feet;
  Matrix3 normal_matrix = Matrix3::Zero();
  Vector3 moment = Vector3::Zero();
  for (int leg = 0; leg < kLegs; ++leg) {
    if (contact[leg] < 0.5) continue;
    const Vector3 arm = dynamics.legs()[leg].p_world_contact - p_mean;
    normal_matrix += arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose();
    moment += arm.cross(motion.col(leg) - v_mean);
  }
  turn = normal_matrix.inverse() * moment;
  return turn.allFinite();
}

// Contact points at rest do not rotate about each other. If the angular velocity with which the
// dynamics were computed is too high by b, the contact points seem to turn with b.
bool rate_from_legs(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                    Vector3& w_base) noexcept {
  FeetMatrix velocities;
  for (int leg = 0; leg < kLegs; ++leg) velocities.col(leg) = dynamics.legs()[leg].v_world_contact;
  Vector3 rate_error;
  if (!turn_of_feet(dynamics, contact, velocities, rate_error)) return false;
  w_base = dynamics.R_world_base().transpose() * (dynamics.w_world_base() - rate_error);
  return true;
}

}  // namespace surefoot
