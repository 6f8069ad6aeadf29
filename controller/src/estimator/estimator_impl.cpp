// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/estimator_impl.hpp"

#include <algorithm>

namespace surefoot {

namespace {

constexpr double kRateTime = 0.005;     // [s] smooths the angular acceleration
constexpr double kNoisePeriod = 0.002;  // [s] the sampling that the noise gains are quoted at
constexpr double kSwingSpeed = 3.0;     // [m/s] how fast a foot off the ground may move
constexpr double kLight = 0.03;         // share of the weight that keeps a foot where it is
constexpr double kLightSpeed = 0.5;     // [m/s] at which one without may slide
constexpr double kLeastTilt = 0.05;     // [rad] doubt about a tilt that two witnesses share
constexpr double kSwingShare = 3.0;     // of its speed relative to the base, besides
constexpr double kSurprise = 1.0;       // [m/s] doubt about the velocity once no foot agrees
constexpr double kAligned = 0.035;      // [rad] of tilt, known well enough to look for biases
constexpr double kStands = 0.9;         // belief of a foot whose noise is learnt
constexpr double kCarried = 0.4;        // share of the weight that feet bear of a robot that stands
constexpr double kFeetDown = 2.5;       // beliefs' sum of the same

// Without its heading, which defines the world's.
Quaternion level_heading(const Quaternion& R) noexcept {
  const Vector3 x_axis = R * Vector3::UnitX();
  const double yaw = std::atan2(x_axis.y(), x_axis.x());
  return Quaternion(Eigen::AngleAxisd(-yaw, Vector3::UnitZ())) * R;
}

Quaternion upright(const Vector3& f_base) noexcept {
  if (f_base.norm() < 1.0) return Quaternion::Identity();  // falls: nothing says where up is
  return Quaternion::FromTwoVectors(f_base, Vector3::UnitZ());
}

// [rad] between the vertical that an accelerometer at rest shows and that of an attitude.
double tilt_between(const Vector3& f_base, const Quaternion& R) noexcept {
  const Vector3 up = upright(f_base).conjugate() * Vector3::UnitZ();
  return std::acos(std::clamp(up.dot(R.conjugate() * Vector3::UnitZ()), -1.0, 1.0));
}

}  // namespace

StateEstimator::Impl::Impl(const Robot& r)
    : robot(r),
      gains(r.config().gains),
      dynamics(r),
      contact(r.mass() * kGravity),
      payload(r.mass()),
      state(r.nq(), r.nv()) {}

void StateEstimator::Impl::reset() noexcept {
  started = has_plan = false;
  reader.reset();
  inertial.reset();
  quaternion.reset();
  torques.reset();
  legs.reset();
  contact.reset();
  slip.reset();
  rise.reset();
  payload.reset();
  push.reset();
  loads.setConstant(1.0 / kLegs);
  moving.setZero();
  rolling.setZero();
  alpha_base.setZero();
  normal = Vector3::UnitZ();
}

void StateEstimator::Impl::read_joints(const LowState& low_state) noexcept {
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = low_state.motorState[i];
    state.q[robot.motor_to_q()[i]] = motor.q;
    state.v[robot.motor_to_v()[i]] = dq[i] = motor.dq;
    tau_est[i] = motor.tauEst;
  }
}

// The filter tracks the IMU's own point, where the accelerometer is right. Feet at height zero; the
// legs say how fast the body moves if they stand.
void StateEstimator::Impl::start() noexcept {
  const Quaternion R = level_heading(imu.has_quaternion ? imu.R_world_base : upright(imu.f_base));
  state.q.segment<4>(3) = R.coeffs();
  w_base = w_smooth = imu.w_base;
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
  const double apart = tilt_between(imu.f_base, R);
  const StartDoubt doubt{std::min(std::max(apart, kLeastTilt), gains.start_tilt),
                         gains.start_velocity, gains.noise_foot_position, 0.0, 0.0};
  filter.reset(R, v_base + dynamics.w_world_base().cross(arm), origin + arm,
               p_feet.colwise() + origin, doubt);
  noise.reset(gains);
  state.contact.setOnes();
  started = true;
  aligned = false;
}

// An attitude that is far off makes the filter see a bias where there is none, and be sure of it.
// So the biases rest until accelerometer and legs have found the tilt; then all doubt begins anew,
// from there.
void StateEstimator::Impl::align() noexcept {
  const auto& P = filter.covariance();
  if (aligned || P(0, 0) + P(1, 1) > kAligned * kAligned) return;
  filter.doubt({kLeastTilt, gains.start_velocity, gains.noise_foot_position,
                gains.start_gyroscope_bias, gains.start_accelerometer_bias});
  aligned = true;
}

void StateEstimator::Impl::predict(double dt) noexcept {
  step = inertial.step(gains, imu, filter, dynamics, state.contact, dt);
  filter.predict(gains, step, foot_variance(dt));
  w_base = step.w_base - filter.gyroscope_bias();
  w_smooth += dt / (dt + kRateTime) * (w_base - w_smooth);
  alpha_base = (w_base - w_smooth) / kRateTime;
}

// Contact points travel with a foot that rolls: the shank's rate times the sole's radius, its mean
// over the tick.
void StateEstimator::Impl::roll_feet(double dt) noexcept {
  const Vector3 lever = robot.config().foot_radius * normal;
  FeetMatrix now;
  for (int leg = 0; leg < kLegs; ++leg) {
    now.col(leg) = state.contact[leg] * dynamics.legs()[leg].w_world_shank.cross(lever);
  }
  filter.move_feet(0.5 * dt * (rolling + now));
  rolling = now;
}

// Feet that bear no load, slip, or were refused may be anywhere soon; those that bear little slide
// easily.
Eigen::Vector4d StateEstimator::Impl::foot_variance(double dt) const noexcept {
  const bool torques_tell = torques.verdict() == Verdict::kGood;
  Eigen::Vector4d out;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double doubt = filter.refused()[leg] ? 1.0 : 1.0 - state.contact[leg];
    const double light = torques_tell ? std::exp(-std::max(loads[leg], 0.0) / kLight) : 0.0;
    const double speed = gains.noise_foot_slip + gains.noise_foot_motion * moving[leg] +
                         doubt * doubt * (kSwingSpeed + kSwingShare * moving[leg]) +
                         light * kLightSpeed + slip.slip()[leg] * slip.speed()[leg];
    out[leg] = speed * speed * kNoisePeriod * dt;
  }
  return out;
}

// Kinematics and dynamics as if the base were at the origin and at rest; moved by correct(). What
// the correction turns the base by is seen by the next tick.
void StateEstimator::Impl::update_dynamics() noexcept {
  if (started) state.q.segment<4>(3) = filter.quaternion().coeffs();  // x y z w
  state.q.head<3>().setZero();
  state.v.head<3>().setZero();
  state.v.segment<3>(3) = w_base;
  dynamics.update(state.q, state.v, normal);
}

Vector3 StateEstimator::Impl::base_acceleration() const noexcept {
  const Vector3& arm = robot.config().p_base_imu;
  const Vector3 felt = step.f_base - filter.accelerometer_bias();
  return felt - kGravity * dynamics.R_world_base().row(2).transpose() - alpha_base.cross(arm) -
         w_base.cross(w_base.cross(arm));
}

void StateEstimator::Impl::find_contacts(const LowState& low_state, double dt) noexcept {
  legs.update(dynamics, base_acceleration(), alpha_base, tau_est, dq, dt);
  const Vector3 v_base = filter.v() - dynamics.w_world_base().cross(dynamics.R_world_base() *
                                                                    robot.config().p_base_imu);
  FeetMatrix v_contact;
  for (int leg = 0; leg < kLegs; ++leg) {
    v_contact.col(leg) = v_base + dynamics.legs()[leg].v_world_contact;
    moving[leg] = dynamics.legs()[leg].v_world_contact.norm();
  }
  slip.update(gains, v_contact, state.contact, dt);
  rise.update(dynamics, filter, v_contact, state.contact, normal, dt);
  ContactSignals signals;
  const double weight = robot.mass() * kGravity;
  loads = legs.forces().transpose() * normal / weight;
  signals.torque_load = loads;
  signals.tau_est = torques.verdict();
  signals.foot_force_est = low_state.footForceEst;  // packed: copied
  signals.foot_force = low_state.footForce;
  signals.speed = slip.speed();
  signals.rise = rise.rise();
  signals.felt = dynamics.R_world_base().row(2).dot(step.f_base) / kGravity;
  contact.update(gains, signals, dt);
  state.contact = contact.probability();
  state.friction = slip.friction(gains);
}

void StateEstimator::Impl::correct(double dt) noexcept {
  const Matrix3& R = dynamics.R_world_base();
  const Vector3 arm = robot.config().p_base_imu;
  roll_feet(dt);
  FeetMatrix y_base;
  for (int leg = 0; leg < kLegs; ++leg) {
    y_base.col(leg) = R.transpose() * dynamics.legs()[leg].p_world_contact - arm;
  }
  filter.correct(y_base, noise.variance(), gains.gate_foot);
  align();
  std::array<bool, kLegs> stands;
  int standing = 0, refused = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool down = state.contact[leg] > kStands;
    stands[leg] = down;
    standing += down;
    refused += down && filter.refused()[leg];
  }
  // What a stopped IMU misses is not the feet's noise.
  const bool fresh = imu.w_age == 1 && imu.f_age <= 2;
  if (fresh) noise.update(filter.foot_nis(), filter.expected(), stands, dt);
  // Standing feet that all contradict the prediction are right: a blow has clipped the
  // accelerometer. Without this the gate would lock them out for ever.
  if (standing >= 2 && refused == standing) filter.doubt_velocity(kSurprise * kSurprise);

  const Vector3 p_base = filter.p() - R * arm;
  const Vector3 v_base = filter.v() - R * w_base.cross(arm);
  state.q.head<3>() = p_base;
  state.v.head<3>() = R.transpose() * v_base;
  dynamics.shift(p_base, v_base);
  const auto& P = filter.covariance();
  const double tilt = std::sqrt(P(0, 0) + P(1, 1));
  quaternion.update(imu, filter.R_world_base(), tilt, dt);
}

bool StateEstimator::Impl::carried() const noexcept {
  const double borne = (legs.forces().transpose() * normal).sum();
  return torques.verdict() == Verdict::kGood && state.contact.sum() > kFeetDown &&
         borne > kCarried * robot.mass() * kGravity;
}

// What the accelerometer feels beyond the plan is laid to a push, at once; what the torques bear
// beyond the model, slowly, to a payload. The plan counts with both already.
void StateEstimator::Impl::observe_outside(double dt) noexcept {
  payload.update(gains, dynamics, legs.forces(), carried(), dt);
  state.f_outside = state.f_lasting = payload.force();
  state.moment_outside = payload.moment();
  if (!has_plan) return;
  // Classical acceleration of the base's origin that is planned.
  const Vector3 a = planned.head<3>() + w_base.cross(Vector3(state.v.head<3>()));
  const Vector3 unexplained = dynamics.R_world_base() * (base_acceleration() - a);
  push.update(gains, unexplained + push.acceleration(gains), dt);
  state.f_outside += robot.mass() * push.acceleration(gains);
}

}  // namespace surefoot
