// SPDX-License-Identifier: BSD-3-Clause
// Start of the estimator: initial state of the filter, and alignment of the tilt before the filter
// estimates biases.
#include <algorithm>

#include "estimator/estimator_impl.hpp"

namespace surefoot {

namespace {

// [rad] Smallest initial standard deviation of the tilt, 3 deg. Chosen equal to kAgreementTilt, the
// tilt difference below which quaternion and accelerometer agree.
constexpr double kMinTiltSigma = 0.05;
// The accelerometer measures gravity alone if the norm of the specific force differs from g by less
// than this share of g. Chosen larger than bias and scale error of an accelerometer
// (start_accelerometer_bias is 0.01 g), and smaller than the accelerations of a moving robot.
constexpr double kRestTolerance = 0.1;
// [rad] Tilt difference below which quaternion and accelerometer agree, 3 deg. Chosen larger than
// 0.6 deg, the tilt error that a bias of 0.1 m/s^2 causes, and smaller than the 5 deg of
// QuaternionTiltCheck.
constexpr double kAgreementTilt = 0.05;
// [rad] The filter estimates biases once the standard deviation of the tilt is below this value,
// 2 deg. Chosen smaller than kMinTiltSigma, so that alignment always takes place, and larger than
// 0.6 deg, the tilt error that an unobservable accelerometer bias causes.
constexpr double kAlignedTiltSigma = 0.035;

// [foot radius] Initial standard deviation of the depth by which soles yield under the weight of
// the robot. Chosen: a sole of rubber yields by less than half of its radius under the load of a
// trotting foot, half of the weight.
constexpr double kSoleSigma = 0.5;

// Remove the heading from an attitude, because the world frame has the heading of the base at the
// first sample.
Quaternion remove_yaw(const Quaternion& R) noexcept {
  const Vector3 x_axis = R * Vector3::UnitX();
  const double yaw = std::atan2(x_axis.y(), x_axis.x());
  return Quaternion(Eigen::AngleAxisd(-yaw, Vector3::UnitZ())) * R;
}

// Return the attitude with zero heading in which the specific force points upwards.
Quaternion attitude_from_accelerometer(const Vector3& f_base) noexcept {
  // Below 1 m/s^2 (chosen) the robot is in free fall, and the specific force shows no vertical.
  if (f_base.norm() < 1.0) return Quaternion::Identity();
  return Quaternion::FromTwoVectors(f_base, Vector3::UnitZ());
}

// Compute the angle [rad] between two verticals: that of an accelerometer at rest, and that of an
// attitude.
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
         tilt_between(imu.f_base, imu.R_world_base) < kAgreementTilt;
}

StateEstimator::Impl::Impl(const Robot& r)
    : robot(r),
      gains(r.config().gains),
      dynamics(r),
      contact(r.mass() * kGravity),
      friction(r),
      joints(r),
      payload(r.mass()),
      state(r.nq(), r.nv()) {}

void StateEstimator::Impl::reset() noexcept {
  started = has_plan = false;
  planned_acceleration.setZero();
  planned_tau.setZero();
  planned_push.setZero();
  path_length = 0.0;
  imu_reader.reset();
  imu_filter_input.reset();
  quaternion_check.reset();
  torque_check.reset();
  leg_forces.reset();
  contact.reset();
  sole_load.reset();
  step_detector.reset();
  standing_check.reset();
  attitude_memory.reset();
  air_time = 0.0;
  slip.reset();
  friction.reset();
  joints.reset();
  state.armature_error.setZero();
  state.joint_damping.setZero();
  state.joint_friction.setZero();
  clearance.reset();
  payload.reset();
  push.reset();
  loads.setConstant(1.0 / kLegs);
  foot_motion.reset();
  alpha_base.setZero();
  normal = Vector3::UnitZ();
}

// Start the filter. Its position is that of the IMU point, because the accelerometer measures
// there. World z = 0 is the mean height of the feet. The base velocity is chosen so that the mean
// velocity of the feet is zero.
void StateEstimator::Impl::initialise() noexcept {
  Quaternion R =
      remove_yaw(imu.has_quaternion ? imu.R_world_base : attitude_from_accelerometer(imu.f_base));
  // A robot that does not measure its attitude may send the quaternion (1, 0, 0, 0), which has unit
  // length too. So at rest, a quaternion whose tilt differs from the tilt of the accelerometer by
  // more than start_tilt is replaced by the tilt of the accelerometer.
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
  // The difference between quaternion and accelerometer is a measure of the uncertainty of the
  // tilt.
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

// Once accelerometer and legs have determined the tilt, reset the covariance with uncertain biases.
// Until then the biases have zero variance: the filter cannot distinguish a large attitude error
// from a bias, and would estimate a wrong bias with a small variance.
void StateEstimator::Impl::align() noexcept {
  const auto& P = filter.covariance();
  if (aligned || P(0, 0) + P(1, 1) > kAlignedTiltSigma * kAlignedTiltSigma) return;
  filter.reset_covariance({kMinTiltSigma, gains.start_velocity, gains.noise_foot_position,
                           gains.start_gyroscope_bias, gains.start_accelerometer_bias,
                           kSoleSigma * robot.config().foot_radius});
  aligned = true;
}

// Restore the initial uncertainty, and discard the biases: with a wrong attitude, the filter has
// estimated wrong biases too.
void StateEstimator::Impl::restart_alignment() noexcept {
  filter.reset_biases();
  filter.reset_covariance(
      {gains.start_tilt, gains.start_velocity, gains.noise_foot_position, 0.0, 0.0});
  quaternion_check.reset();
  aligned = false;
}

}  // namespace surefoot
