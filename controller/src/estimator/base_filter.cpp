// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/base_filter.hpp"

namespace surefoot {

namespace {

constexpr double kNoisePeriod = 0.002;  // [s] the sampling that the noise gains are quoted at
constexpr double kSwingSpeed = 3.0;     // [m/s] how fast a foot off the ground may move
constexpr double kSurprise = 1.0;       // [m/s] doubt about the velocity once no foot agrees
constexpr double kSwingSigma = 1.0;     // [m/s] velocity noise of a foot off the ground

}  // namespace

void BaseFilter::reset(const Vector3& p_imu, const FeetMatrix& p_feet) noexcept {
  x_.setZero();
  x_.row(0) = p_imu.transpose();
  x_.bottomRows<4>() = p_feet.transpose();
  P_.setZero();
  P_.diagonal() << 0.0, 0.01, 1e-4, 1e-4, 1e-4, 1e-4;
  wandering_.fill(false);
}

void BaseFilter::update(const Gains& gains, const Vector3& f_world, const Vector3& p_imu,
                        const Vector3& v_imu, const Dynamics& dynamics,
                        const Eigen::Vector4d& contact, double dt) noexcept {
  predict(gains, f_world - kGravity * Vector3::UnitZ(), contact, dt);
  refused_ = 0;
  int stance = 0, velocities_refused = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    Vector6 h_position = Vector6::Zero();
    h_position[0] = -1.0;
    h_position[2 + leg] = 1.0;
    const double position_variance = gains.noise_foot_position * gains.noise_foot_position;
    const bool position_ok =
        correct(h_position, L.p_world_contact - p_imu, position_variance, gains.gate_foot);

    // v_foot = v_base + v_relative = 0 in stance, and v_imu = v_base + w x p_imu.
    const double doubt = 1.0 - contact[leg];
    const double sigma = gains.noise_foot_velocity + doubt * doubt * kSwingSigma;
    const bool velocity_ok =
        correct(Vector6::Unit(1), v_imu - L.v_world_contact, sigma * sigma, gains.gate_foot);
    wandering_[leg] = !(position_ok && velocity_ok);
    refused_ += !position_ok + !velocity_ok;
    stance += contact[leg] > 0.5;
    velocities_refused += contact[leg] > 0.5 && !velocity_ok;
  }
  // Standing feet that all contradict the prediction are right: a blow has clipped the
  // accelerometer.
  // Without this the gate would lock them out for ever.
  if (stance >= 2 && velocities_refused == stance) P_(1, 1) += kSurprise * kSurprise;
}

void BaseFilter::predict(const Gains& gains, const Vector3& a_world, const Eigen::Vector4d& contact,
                         double dt) noexcept {
  x_.row(0) += dt * x_.row(1) + 0.5 * dt * dt * a_world.transpose();
  x_.row(1) += dt * a_world.transpose();
  P_.row(0) += dt * P_.row(1);
  P_.col(0) += dt * P_.col(1);
  const double spread = dt * kNoisePeriod;
  P_(1, 1) += gains.noise_accelerometer * gains.noise_accelerometer * spread;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double doubt = wandering_[leg] ? 1.0 : 1.0 - contact[leg];
    const double speed = gains.noise_foot_slip + doubt * doubt * kSwingSpeed;
    P_(2 + leg, 2 + leg) += speed * speed * spread;
  }
}

// One scalar-variance measurement of all three axes: they share h, P and hence the gain.
bool BaseFilter::correct(const Vector6& h, const Vector3& measured, double variance,
                         double gate) noexcept {
  const Vector3 innovation = measured - x_.transpose() * h;
  const Vector6 Ph = P_ * h;
  const double s = h.dot(Ph) + variance;
  if (innovation.squaredNorm() > gate * gate * s) return false;
  const Vector6 gain = Ph / s;
  x_.noalias() += gain * innovation.transpose();
  // Joseph form: stays symmetric and positive whatever the rounding.
  Matrix6 keep = Matrix6::Identity();
  keep.noalias() -= gain * h.transpose();
  P_ = keep * P_ * keep.transpose() + variance * gain * gain.transpose();
  return true;
}

}  // namespace surefoot
