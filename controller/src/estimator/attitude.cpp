// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/attitude.hpp"

#include <Eigen/LU>

namespace surefoot {

namespace {

constexpr double kBiasMax = 0.1;      // [rad/s] no sane gyroscope is off by more
constexpr double kMisfit = 2.0;       // of a foot's velocity noise
constexpr double kAlignTime = 1.0;    // [s] and kAlignGain: follow faster at first, because
constexpr double kAlignGain = 2.0;    // [1/s] the vendor's filter may start far off
constexpr double kBelievableG = 1.0;  // [m/s^2] |f| further from g than this is no plumb line

constexpr double kMovingG = 1.0;  // [m/s^2] asked of the base at which trust has halved

}  // namespace

Status read_imu(const IMU& imu, const RobotConfig& config, ImuReading& out) noexcept {
  // Packed fields are not aligned: copy them before indexing.
  const std::array<float, 4> quaternion = imu.quaternion;
  const std::array<float, 3> gyroscope = imu.gyroscope, accelerometer = imu.accelerometer;
  Quaternion R_world_imu(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
  const double norm = R_world_imu.norm();
  if (!(std::abs(norm - 1.0) <= 0.05)) return Status::kBadQuaternion;
  R_world_imu.normalize();

  const Eigen::Vector4d& mount = config.quat_base_imu;
  const Quaternion R_base_imu(mount[0], mount[1], mount[2], mount[3]);
  out.R_world_base = R_world_imu * R_base_imu.conjugate();
  out.w_base = R_base_imu * Vector3(gyroscope[0], gyroscope[1], gyroscope[2]);
  out.f_base = R_base_imu * Vector3(accelerometer[0], accelerometer[1], accelerometer[2]);
  return Status::kOk;
}

void AttitudeFilter::reset(const ImuReading& imu) noexcept {
  const Vector3 x_axis = imu.R_world_base * Vector3::UnitX();
  const Quaternion R_level(
      Eigen::AngleAxisd(-std::atan2(x_axis.y(), x_axis.x()), Vector3::UnitZ()));
  R_world_base_ = R_level * imu.R_world_base;
  bias_.setZero();
  age_ = 0.0;
  w_base_ = imu.w_base;
}

void AttitudeFilter::update(const Gains& gains, const ImuReading& imu, double acceleration,
                            double dt) noexcept {
  w_base_ = imu.w_base - bias_;
  Vector3 turn = w_base_;
  const double magnitude = imu.f_base.norm();
  if (std::abs(magnitude - kGravity) < kBelievableG) {
    const Vector3 up_base = R_world_base_.conjugate() * Vector3::UnitZ();
    const double gain = gains.attitude_gain + kAlignGain * std::exp(-age_ / kAlignTime);
    const double moved = acceleration / kMovingG;
    turn += gain / (1.0 + moved * moved) * (imu.f_base / magnitude).cross(up_base);
  }
  age_ += dt;
  R_world_base_ = (R_world_base_ * exp_so3(dt * turn)).normalized();
}

// Contact points at rest: v_base + v_i = 0 for every stance foot, where v_i holds w x p_i. A rate
// that is wrong by b leaves v_i - mean = b x (p_i - mean): least squares for b over the feet.
void AttitudeFilter::learn_bias(const Gains& gains, const Dynamics& dynamics,
                                const Eigen::Vector4d& contact, double dt) noexcept {
  if (contact.minCoeff() < 0.99) return;
  Vector3 p_mean = Vector3::Zero(), v_mean = Vector3::Zero();
  for (const LegDynamics& L : dynamics.legs()) {
    p_mean += 0.25 * L.p_world_contact;
    v_mean += 0.25 * L.v_world_contact;
  }
  Matrix3 normal_matrix = Matrix3::Zero();
  Vector3 moment = Vector3::Zero();
  for (const LegDynamics& L : dynamics.legs()) {
    const Vector3 arm = L.p_world_contact - p_mean;
    normal_matrix += arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose();
    moment += arm.cross(L.v_world_contact - v_mean);
  }
  const Vector3 wrong = normal_matrix.inverse() * moment;
  if (!wrong.allFinite() || !(wrong.norm() < kBiasMax)) return;
  // One leg that lies, or slips, does not fit a common turn: then nothing is learnt.
  for (const LegDynamics& L : dynamics.legs()) {
    const Vector3 misfit = L.v_world_contact - v_mean - wrong.cross(L.p_world_contact - p_mean);
    if (misfit.norm() > kMisfit * gains.noise_foot_velocity) return;
  }
  bias_ += dt / (dt + gains.gyro_bias_time) * (R_world_base_.conjugate() * wrong);
  bias_ = bias_.cwiseMax(-kBiasMax).cwiseMin(kBiasMax);
}

}  // namespace surefoot
