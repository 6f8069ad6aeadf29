// SPDX-License-Identifier: BSD-3-Clause
// How the estimator begins: where the filter starts, and when it begins to look for biases.
#include <algorithm>

#include "estimator/estimator_impl.hpp"

namespace surefoot {

namespace {

constexpr double kMinTiltSigma = 0.05;  // [rad] doubt about a tilt that two witnesses share
constexpr double kRestTolerance = 0.1;  // of g by which what is felt at rest may be off
constexpr double kMaxTiltDifference =
    0.05;  // [rad] by which two that vouch for each other may differ
constexpr double kAlignedTiltSigma = 0.035;  // [rad] of tilt, known well enough to look for biases

// Without its heading, which defines the world's.
Quaternion remove_yaw(const Quaternion& R) noexcept {
  const Vector3 x_axis = R * Vector3::UnitX();
  const double yaw = std::atan2(x_axis.y(), x_axis.x());
  return Quaternion(Eigen::AngleAxisd(-yaw, Vector3::UnitZ())) * R;
}

Quaternion attitude_from_accelerometer(const Vector3& f_base) noexcept {
  if (f_base.norm() < 1.0) return Quaternion::Identity();  // falls: nothing says where up is
  return Quaternion::FromTwoVectors(f_base, Vector3::UnitZ());
}

// [rad] between the vertical that an accelerometer at rest shows and that of an attitude.
double tilt_between(const Vector3& f_base, const Quaternion& R) noexcept {
  const Vector3 up = attitude_from_accelerometer(f_base).conjugate() * Vector3::UnitZ();
  return std::acos(std::clamp(up.dot(R.conjugate() * Vector3::UnitZ()), -1.0, 1.0));
}

bool measures_gravity(const Vector3& f_base) noexcept {
  return std::abs(f_base.norm() - kGravity) < kRestTolerance * kGravity;
}

}  // namespace

bool accelerometer_matches_quaternion(const ImuReading& imu) noexcept {
  return imu.has_quaternion && imu.accelerometer == SensorVerdict::kGood &&
         measures_gravity(imu.f_base) &&
         tilt_between(imu.f_base, imu.R_world_base) < kMaxTiltDifference;
}

StateEstimator::Impl::Impl(const Robot& r)
    : robot(r),
      gains(r.config().gains),
      dynamics(r),
      contact(r.mass() * kGravity),
      payload(r.mass()),
      state(r.nq(), r.nv()) {}

void StateEstimator::Impl::reset() noexcept {
  started = has_plan = false;
  planned_acceleration.setZero();
  planned_tau.setZero();
  planned_push.setZero();
  path_length = 0.0;
  imu_reader.reset();
  imu_preprocessor.reset();
  quaternion_check.reset();
  torque_check.reset();
  leg_forces.reset();
  contact.reset();
  slip.reset();
  clearance.reset();
  payload.reset();
  push.reset();
  loads.setConstant(1.0 / kLegs);
  foot_motion.reset();
  alpha_base.setZero();
  normal = Vector3::UnitZ();
}

// The filter tracks the IMU's own point, where the accelerometer is right. Feet at height zero; the
// legs say how fast the body moves if they stand.
void StateEstimator::Impl::initialise() noexcept {
  Quaternion R =
      remove_yaw(imu.has_quaternion ? imu.R_world_base : attitude_from_accelerometer(imu.f_base));
  // A field that is not filled, 1 0 0 0, is of unit length, too: gravity knows better at rest.
  if (measures_gravity(imu.f_base) && tilt_between(imu.f_base, R) > gains.start_tilt)
    R = attitude_from_accelerometer(imu.f_base);
  state.q.segment<4>(3) = R.coeffs();
  w_base = w_filtered = imu.w_base;
  update_dynamics();
  FeetMatrix p_feet;
  Vector3 v_base = Vector3::Zero();
  for (int leg = 0; leg < kLegs; ++leg) {
    p_feet.col(leg) = dynamics.legs()[leg].p_world_contact;
    v_base -= 0.25 * dynamics.legs()[leg].v_world_contact;
  }
  const Vector3 arm = R * robot.config().p_base_imu;
  const Vector3 origin(0.0, 0.0, -p_feet.row(2).mean());
  // The vendor's attitude and the accelerometer's vertical vouch for each other.
  const double tilt_difference = tilt_between(imu.f_base, R);
  const InitialSigmas sigmas{std::min(std::max(tilt_difference, kMinTiltSigma), gains.start_tilt),
                             gains.start_velocity, gains.noise_foot_position, 0.0, 0.0};
  filter.reset(R, v_base + dynamics.w_world_base().cross(arm), origin + arm,
               p_feet.colwise() + origin, sigmas);
  foot_noise.reset(gains);
  state.contact.setOnes();
  started = true;
  aligned = false;
}

// An attitude that is far off makes the filter see a bias where there is none, and be sure of it.
// So the biases rest until accelerometer and legs have found the tilt; then all doubt begins anew,
// from there.
void StateEstimator::Impl::align() noexcept {
  const auto& P = filter.covariance();
  if (aligned || P(0, 0) + P(1, 1) > kAlignedTiltSigma * kAlignedTiltSigma) return;
  filter.reset_covariance({kMinTiltSigma, gains.start_velocity, gains.noise_foot_position,
                           gains.start_gyroscope_bias, gains.start_accelerometer_bias});
  aligned = true;
}

// As at the start: biases that were learnt with a wrong attitude are none.
void StateEstimator::Impl::restart_alignment() noexcept {
  filter.reset_biases();
  filter.reset_covariance(
      {gains.start_tilt, gains.start_velocity, gains.noise_foot_position, 0.0, 0.0});
  quaternion_check.reset();
  aligned = false;
}

}  // namespace surefoot
