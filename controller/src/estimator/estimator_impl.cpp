// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/estimator_impl.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [s] Time constant of the filter that differentiates the angular velocity. Equal to
// LegForces::kFilterTime.
constexpr double kRateFilterTime = 0.005;
// [m/s] The motion of the base counts in path_length only above this speed. Chosen larger than the
// velocity noise of a robot at rest. If much larger: slow motion is not counted, although it too
// causes a position error by wrong leg lengths (gain leg_scale).
constexpr double kMinTravelSpeed = 0.05;
// [m/s] When most stance feet are rejected and do not slide, the square of this value is added to
// the variance of the velocity. Chosen larger than the velocity error after a blow that saturates
// the accelerometer. Test: test_estimate_recovers_from_a_saturated_accelerometer.
constexpr double kRecoveryVelocitySigma = 1.0;
// Contact confidence above which a foot counts as a stance foot for FootNoise and for the recovery
// from rejected feet. Chosen larger than 0.5, which is reached half-way through contact_dwell, and
// smaller than 1, which a foot may never reach if one source disagrees.
constexpr double kCertainContact = 0.9;
// [rad/s] Angular rate below which the body counts as at rest. Chosen larger than bias and noise of
// the gyroscope (0.02 and 0.01 rad/s by default). If larger: a rotation whose centripetal
// acceleration disturbs the accelerometer counts as rest.
constexpr double kRestRate = 0.2;
// The feet carry the robot if both of these limits are exceeded.
//
// Limit of the sum of the loads of all feet, as a share of the weight. Chosen between 0, the sum in
// the air, and 1, the sum at rest.
constexpr double kSupportedShare = 0.4;
// Limit of the sum of the contact confidences. Derived: half-way between two and three feet.
constexpr double kMinContactSum = 2.5;
// Standard deviations of the base velocity by which a contact point must move before its motion
// counts. Chosen: three exclude nearly all errors. With none, a velocity that vibration has made
// wrong would make the filter ignore the feet that contradict it.
constexpr double kSpeedSigmas = 3.0;
// Share of the sink of a sole by which the lever of its rolling is shorter than the radius of the
// foot. Chosen: half-way between a rigid sole, which rolls about its lowest point, and the plane of
// the ground. The effective radius of tyres is shorter by a third of the sink.
constexpr double kRollingShare = 0.5;

}  // namespace

void StateEstimator::Impl::read_joints(const LowState& low_state) noexcept {
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = low_state.motorState[i];
    state.q[robot.motor_to_q()[i]] = motor.q;
    state.v[robot.motor_to_v()[i]] = dq[i] = motor.dq;
    q[i] = motor.q;
    tau_est[i] = motor.tauEst;
  }
}

void StateEstimator::Impl::predict(double dt) noexcept {
  imu_input = imu_filter_input.update(
      gains, imu, filter, dynamics,
      {state.contact, step_detector.steps(), step_detector.rests(), off_ground()}, dt);
  if (imu_filter_input.gyroscope_rejected()) imu.gyroscope = SensorVerdict::kDisagrees;
  filter.predict(gains, imu_input, foot_motion.process_variance(gains, foot_contact_state(), dt),
                 sole_load.process_variance(robot.config().foot_radius, dt));
  w_base = imu_input.w_base - filter.gyroscope_bias();
  w_filtered += dt / (dt + kRateFilterTime) * (w_base - w_filtered);
  alpha_base = (w_base - w_filtered) / kRateFilterTime;
}

double StateEstimator::Impl::velocity_error() const noexcept {
  const auto& P = filter.covariance();
  return kSpeedSigmas * std::sqrt(P(3, 3) + P(4, 4) + P(5, 5));
}

FootContactState StateEstimator::Impl::foot_contact_state() const noexcept {
  FootContactState out{state.contact,          loads,
                       slip.speed(),           step_detector.steps(),
                       filter.rejected_feet(), friction.at_limit()};
  // Without new values of the IMU, the body moves and not the feet.
  if (!imu_is_fresh()) out.speed.setZero();
  // A wrong velocity of the base makes all contact points seem to move.
  out.speed = (out.speed.array() - velocity_error()).max(0.0);
  if (!torques_valid()) out.load.setOnes();
  return out;
}

// Compute kinematics and dynamics with the base at the origin and without linear velocity;
// correct() shifts the results to the estimated position and velocity. The attitude in state.q is
// the predicted attitude: this tick's correction of the attitude takes effect in the next tick.
void StateEstimator::Impl::update_dynamics() noexcept {
  if (started) state.q.segment<4>(3) = filter.quaternion().coeffs();  // x y z w
  state.q.head<3>().setZero();
  state.v.head<3>().setZero();
  state.v.segment<3>(3) = w_base;
  dynamics.set_joints(state);
  dynamics.update(state.q, state.v, normal);
}

Vector3 StateEstimator::Impl::base_acceleration() const noexcept {
  const Vector3& arm = robot.config().p_base_imu;
  const Vector3 specific_force = imu_input.f_base - filter.accelerometer_bias();
  return specific_force - kGravity * dynamics.R_world_base().row(2).transpose() -
         alpha_base.cross(arm) - w_base.cross(w_base.cross(arm));
}

void StateEstimator::Impl::update_contacts(const LowState& low_state, double dt) noexcept {
  const Vector12 stops = joint_stops(robot.config(), q);
  leg_forces.update(dynamics, base_acceleration(), alpha_base,
                    torques_valid() ? tau_est : planned_tau, dq, stops, dt);
  check_standing(dt);
  const Vector3 v_base = filter.v() - dynamics.w_world_base().cross(dynamics.R_world_base() *
                                                                    robot.config().p_base_imu);
  FeetMatrix v_contact;
  for (int leg = 0; leg < kLegs; ++leg) {
    v_contact.col(leg) = v_base + dynamics.legs()[leg].v_world_contact;
  }
  foot_motion.update_velocity(dynamics, dt);
  slip.update(gains, {v_contact, state.contact, loads, normal, step_detector.stepped_lately()}, dt);
  clearance.update(dynamics, filter, slip.velocity(), state.contact, contact.loaded_by_forces(),
                   normal, dt);
  ContactSignals signals;
  const double weight = robot.mass() * kGravity;
  loads = leg_forces.forces().transpose() * normal / weight;
  signals.torque_load = loads;
  signals.tau_est = torque_check.verdict();
  signals.foot_force_est = low_state.footForceEst;  // the field is packed, so it is copied
  signals.foot_force = low_state.footForce;
  signals.speed = slip.excess_speed();
  // The feet of a robot that steps land at other heights while some of them are in the air, so the
  // height of a foot above its last place says nothing about its contact.
  if (!step_detector.steps()) signals.clearance = clearance.clearance();
  signals.load_factor = dynamics.R_world_base().row(2).dot(imu_input.f_base) / kGravity;
  signals.steps = step_detector.steps();
  signals.standing_refuted = standing_check.refuted();
  contact.update(gains, signals, dt);
  state.contact = contact.confidence();
  step_detector.update(state.contact, dt);
  const double travelled = v_base.norm() > kMinTravelSpeed ? dt * v_base.norm() : 0.0;
  friction.update({v_contact, leg_forces.forces(), state.contact, normal, velocity_error(),
                   travelled, step_detector.stepped_lately()},
                  dt);
  state.friction = friction.usable_share() * slip.friction(gains);
  learn_joints(v_contact, stops, dt);
  state.armature_error = joints.armature_error();
  // The friction of its joints damps a standing robot, so it is not compensated there.
  const double share = step_detector.stepped_lately() ? 1.0 : 0.0;
  state.joint_damping = share * joints.damping();
  state.joint_friction = share * joints.friction();
  // Without torques, the feet in contact share the weight equally.
  sole_load.update(
      torques_valid() ? loads : Eigen::Vector4d(state.contact / std::max(state.contact.sum(), 1.0)),
      step_detector.steps(), dt);
}

// Only a robot that steps swings its legs; the legs of any other robot may be moved by hand.
void StateEstimator::Impl::learn_joints(const FeetMatrix& v_contact, const Vector12& stops,
                                        double dt) noexcept {
  const auto used = [](SensorVerdict verdict) { return verdict <= SensorVerdict::kUnjudged; };
  const bool imu_valid = imu_is_fresh() && used(imu.accelerometer) && used(imu.gyroscope);
  if (!torques_valid() || !imu_valid || !step_detector.steps()) return joints.pause();
  joints.update({dynamics, v_contact, leg_forces.swing_torque(), q, stops}, dt);
}

void StateEstimator::Impl::correct(double dt) noexcept {
  const Matrix3& R = dynamics.R_world_base();
  const Vector3 arm = robot.config().p_base_imu;
  FeetInput feet;
  feet.lever = robot.config().foot_radius * normal;
  feet.variance = foot_noise.variance();
  feet.normal = normal;
  feet.load = sole_load.load();
  feet.normal_variance = sole_load.sink_variance(filter.sole_compliance(), dt);
  feet.load_changes = sole_load.changes();
  feet.steps = step_detector.steps();
  feet.slides = friction.slides();
  const FeetMatrix rolling_lever =
      (-kRollingShare * normal * sole_sink().transpose()).colwise() + feet.lever;
  filter.move_feet(foot_motion.rolling_displacement(dynamics, q, state.contact, rolling_lever, dt));
  for (int leg = 0; leg < kLegs; ++leg) {
    feet.y_base.col(leg) = R.transpose() * dynamics.legs()[leg].p_world_contact - arm;
  }
  filter.correct(feet, gains.gate_foot);
  correct_off_ground(dt);
  align();
  std::array<bool, kLegs> stance;
  int stance_count = 0, rejected_count = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool in_stance = state.contact[leg] > kCertainContact;
    stance[leg] = in_stance;
    stance_count += in_stance;
    rejected_count += in_stance && filter.rejected_feet()[leg] && !feet.slides[leg];
  }
  // While the IMU repeats old values, the innovations contain motion that the IMU did not measure.
  // The noise of the feet must not adapt to this motion.
  if (imu_is_fresh()) foot_noise.update(filter.foot_nis(), filter.predicted_variance(), stance, dt);
  // If the gate rejects most stance feet and they do not slide, the prediction is wrong and the
  // feet are right: a blow has saturated the accelerometer, or fell between two of its samples. The
  // variance must grow, or the gate would reject the feet for ever.
  if (stance_count >= 2 && 2 * rejected_count > stance_count)
    filter.add_velocity_variance(kRecoveryVelocitySigma * kRecoveryVelocitySigma);

  const Vector3 p_base = filter.p() - R * arm;
  const Vector3 v_base = filter.v() - R * w_base.cross(arm);
  if (v_base.norm() > kMinTravelSpeed) path_length += dt * v_base.norm();
  state.q.head<3>() = p_base;
  state.v.head<3>() = R.transpose() * v_base;
  dynamics.shift(p_base, v_base);
  const auto& P = filter.covariance();
  const double tilt = std::sqrt(P(0, 0) + P(1, 1));
  quaternion_check.update(imu, filter.R_world_base(), tilt, dt);
  if (attitude_diverged()) restart_alignment();
}

// Return whether the attitude of the filter has diverged, for example because a gyroscope fault was
// detected too late. It has diverged if the body is at rest, and IMU quaternion and accelerometer
// agree with each other but the quaternion contradicts the filter.
bool StateEstimator::Impl::attitude_diverged() const noexcept {
  if (quaternion_check.verdict() != SensorVerdict::kDisagrees || w_filtered.norm() > kRestRate)
    return false;
  return accelerometer_matches_quaternion(imu);
}

// Return whether the feet carry the robot, and joint torques are available, measured or planned.
bool StateEstimator::Impl::supported() const noexcept {
  const double total_load = (leg_forces.forces().transpose() * normal).sum();
  return (torques_valid() || has_plan) && state.contact.sum() > kMinContactSum &&
         total_load > kSupportedShare * robot.mass() * kGravity;
}

// Compute the external wrench. PayloadObserver slowly attributes the contact forces that the model
// does not explain to a payload. PushObserver quickly attributes the acceleration that the planned
// motion does not explain to a push. The planned motion already contains the payload and the push
// that were estimated when the motion was planned.
void StateEstimator::Impl::observe_external_wrench(double dt) noexcept {
  const bool supported = this->supported();
  // The forces of feet that land and lift off are not known well enough to weigh a payload.
  payload.update(gains, dynamics, leg_forces.forces(), supported, step_detector.steps(), dt);
  state.f_external = state.f_sustained = payload.force();
  state.moment_external = payload.moment();
  if (!has_plan) return;
  if (step_detector.planned()) return push.reset();
  // `a` is the planned classical acceleration of the base origin, base axes. It includes the effect
  // of planned_push, the push that was estimated when the plan was made. The feet do not cause this
  // part: a_feet = a - planned_push / m. So a_measured - a_feet = unplanned + planned_push / m.
  const Vector3 a = planned_acceleration.head<3>() + w_base.cross(Vector3(state.v.head<3>()));
  const Vector3 unplanned = dynamics.R_world_base() * (base_acceleration() - a);
  push.update(gains, unplanned + planned_push / robot.mass(), supported, dt);
  state.f_external += robot.mass() * push.acceleration(gains);
}

}  // namespace surefoot
