// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/estimator_impl.hpp"

#include <algorithm>

namespace surefoot {

namespace {

constexpr double kRateTime = 0.005;  // [s] smooths the angular acceleration
constexpr double kTravels = 0.05;    // [m/s] slower is not travelling, but noise
constexpr double kSurprise = 1.0;    // [m/s] doubt about the velocity once no foot agrees
constexpr double kStands = 0.9;      // belief of a foot whose noise is learnt
constexpr double kStill = 0.2;       // [rad/s] of a body at rest
constexpr double kCarried = 0.4;     // share of the weight that feet bear of a robot that stands
constexpr double kFeetDown = 2.5;    // beliefs' sum of the same

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
  step = inertial.step(gains, imu, filter, dynamics, state.contact, dt);
  if (inertial.outvoted()) imu.gyroscope = Verdict::kDisagrees;
  filter.predict(gains, step, wander.variance(gains, feet_beliefs(), dt));
  w_base = step.w_base - filter.gyroscope_bias();
  w_smooth += dt / (dt + kRateTime) * (w_base - w_smooth);
  alpha_base = (w_base - w_smooth) / kRateTime;
}

FootBeliefs StateEstimator::Impl::feet_beliefs() const noexcept {
  FootBeliefs out{state.contact, loads, slip.slip().cwiseProduct(slip.speed()), filter.refused()};
  if (!torques_tell()) out.load.setOnes();
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
  legs.update(dynamics, base_acceleration(), alpha_base, torques_tell() ? tau_est : planned_tau, dq,
              stops_at(robot.config(), q), dt);
  const Vector3 v_base = filter.v() - dynamics.w_world_base().cross(dynamics.R_world_base() *
                                                                    robot.config().p_base_imu);
  FeetMatrix v_contact;
  for (int leg = 0; leg < kLegs; ++leg) {
    v_contact.col(leg) = v_base + dynamics.legs()[leg].v_world_contact;
  }
  wander.see(dynamics, dt);
  slip.update(gains, v_contact, state.contact, dt);
  rise.update(dynamics, filter, slip.velocity(), state.contact, contact.bears(), normal, dt);
  ContactSignals signals;
  const double weight = robot.mass() * kGravity;
  loads = legs.forces().transpose() * normal / weight;
  signals.torque_load = loads;
  signals.tau_est = torques.verdict();
  signals.foot_force_est = low_state.footForceEst;  // packed: copied
  signals.foot_force = low_state.footForce;
  signals.speed = slip.excess();
  signals.rise = rise.rise();
  signals.felt = dynamics.R_world_base().row(2).dot(step.f_base) / kGravity;
  contact.update(gains, signals, dt);
  state.contact = contact.probability();
  state.friction = slip.friction(gains);
}

void StateEstimator::Impl::correct(double dt) noexcept {
  const Matrix3& R = dynamics.R_world_base();
  const Vector3 arm = robot.config().p_base_imu;
  const Vector3 lever = robot.config().foot_radius * normal;
  filter.move_feet(wander.roll(dynamics, q, state.contact, lever, dt));
  FeetMatrix y_base;
  for (int leg = 0; leg < kLegs; ++leg) {
    y_base.col(leg) = R.transpose() * dynamics.legs()[leg].p_world_contact - arm;
  }
  filter.correct(y_base, noise.variance(), gains.gate_foot, lever);
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
  if (v_base.norm() > kTravels) way += dt * v_base.norm();
  state.q.head<3>() = p_base;
  state.v.head<3>() = R.transpose() * v_base;
  dynamics.shift(p_base, v_base);
  const auto& P = filter.covariance();
  const double tilt = std::sqrt(P(0, 0) + P(1, 1));
  quaternion.update(imu, filter.R_world_base(), tilt, dt);
  if (misled()) align_anew();
}

// Has the filter been led astray, by a gyroscope that nobody contradicted in time? The vendor's
// attitude and the accelerometer of a robot at rest agree with each other, and not with it.
bool StateEstimator::Impl::misled() const noexcept {
  if (quaternion.verdict() != Verdict::kDisagrees || w_smooth.norm() > kStill) return false;
  return vouch_for_each_other(imu);
}

bool StateEstimator::Impl::carried() const noexcept {
  const double borne = (legs.forces().transpose() * normal).sum();
  return (torques_tell() || has_plan) && state.contact.sum() > kFeetDown &&
         borne > kCarried * robot.mass() * kGravity;
}

// What the accelerometer feels beyond the plan is laid to a push, at once; what the torques bear
// beyond the model, slowly, to a payload. The plan counts with both already.
void StateEstimator::Impl::observe_outside(double dt) noexcept {
  const bool carried = this->carried();
  payload.update(gains, dynamics, legs.forces(), carried, dt);
  state.f_outside = state.f_lasting = payload.force();
  state.moment_outside = payload.moment();
  if (!has_plan) return;
  // Classical acceleration of the base's origin that is planned. It counted with the push that was
  // believed in when it was made, which is none of the feet's doing.
  const Vector3 a = planned.head<3>() + w_base.cross(Vector3(state.v.head<3>()));
  const Vector3 unplanned = dynamics.R_world_base() * (base_acceleration() - a);
  push.update(gains, unplanned + planned_push / robot.mass(), carried, dt);
  state.f_outside += robot.mass() * push.acceleration(gains);
}

}  // namespace surefoot
