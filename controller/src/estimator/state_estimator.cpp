// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/state_estimator.hpp"

#include "estimator/attitude.hpp"
#include "estimator/base_filter.hpp"
#include "estimator/contact_estimator.hpp"
#include "estimator/push_observer.hpp"
#include "low_state_check.hpp"
#include "surefoot/stage_clock.hpp"

namespace surefoot {

namespace {
constexpr double kLongestStep = 0.1;  // [s] longer steps say nothing about what happened meanwhile
}

struct StateEstimator::Impl {
  explicit Impl(const Robot& r)
      : robot(r),
        gains(r.config().gains),
        dynamics(r),
        contact(r.mass() * kGravity),
        state(r.nq(), r.nv()) {}
  void read_joints(const LowState& low_state) noexcept;
  void place_base(const Vector3& f_base, double dt) noexcept;
  void observe_push(const Vector3& f_base, double dt) noexcept;

  Robot robot;
  Gains gains;
  Dynamics dynamics;
  AttitudeFilter attitude;
  ContactEstimator contact;
  BaseFilter filter;
  PushObserver push;
  Vector6 planned = Vector6::Zero();
  bool has_plan = false;
  RobotState state;
  EstimatorReport report;
  Vector12 tau_est = Vector12::Zero();
  Vector3 normal = Vector3::UnitZ();
  bool started = false;
};

StateEstimator::StateEstimator(const Robot& robot) : impl_(std::make_unique<Impl>(robot)) {}
StateEstimator::~StateEstimator() = default;
StateEstimator::StateEstimator(StateEstimator&&) noexcept = default;

const RobotState& StateEstimator::state() const noexcept { return impl_->state; }
const Dynamics& StateEstimator::dynamics() const noexcept { return impl_->dynamics; }
const EstimatorReport& StateEstimator::report() const noexcept { return impl_->report; }
bool StateEstimator::foot_force_alive() const noexcept { return impl_->contact.foot_force_alive(); }
const Eigen::Vector4d& StateEstimator::torque_force() const noexcept {
  return impl_->contact.torque_force();
}

void StateEstimator::set_gains(const Gains& gains) {
  gains.validate();
  impl_->gains = gains;
}

void StateEstimator::set_ground_normal(const Vector3& normal) noexcept { impl_->normal = normal; }

void StateEstimator::set_planned_acceleration(const Vector6& a_base) noexcept {
  impl_->planned = a_base;
  impl_->has_plan = true;
}

void StateEstimator::reset() noexcept {
  impl_->started = false;
  impl_->contact.reset();
  impl_->push.reset();
  impl_->has_plan = false;
  impl_->normal = Vector3::UnitZ();
}

Status StateEstimator::update(const LowState& low_state, double dt) noexcept {
  const StageScope stage(Stage::kEstimate);
  Impl& s = *impl_;
  if (!(dt > 0.0 && dt <= kLongestStep)) return Status::kStaleTick;
  Status status = check_low_state(low_state, s.robot.config());
  if (status != Status::kOk) return status;
  ImuReading imu;
  status = read_imu(low_state.imu, s.robot.config(), imu);
  if (status != Status::kOk) return status;
  if (!s.started) s.attitude.reset(imu);
  const double asked = s.has_plan ? s.planned.head<3>().norm() : 0.0;
  s.attitude.update(s.gains, imu, asked, dt);

  // Kinematics and dynamics as if the base were at the origin and at rest; moved below.
  s.read_joints(low_state);
  s.state.q.head<3>().setZero();
  s.state.q.segment<4>(3) = s.attitude.R_world_base().coeffs();  // x y z w
  s.state.v.head<3>().setZero();
  s.state.v.segment<3>(3) = s.attitude.w_base();
  s.dynamics.update(s.state.q, s.state.v, s.normal);

  const std::array<std::int16_t, kLegs> foot_force_est = low_state.footForceEst;  // packed: copy
  s.contact.update(s.gains, s.dynamics, s.tau_est, foot_force_est, s.normal, dt);
  s.state.contact = s.contact.probability();
  s.attitude.learn_bias(s.gains, s.dynamics, s.state.contact, dt);
  s.place_base(imu.f_base, dt);
  s.observe_push(imu.f_base, dt);
  return Status::kOk;
}

void StateEstimator::Impl::read_joints(const LowState& low_state) noexcept {
  for (int i = 0; i < kMotors; ++i) {
    const MotorState& motor = low_state.motorState[i];
    state.q[robot.motor_to_q()[i]] = motor.q;
    state.v[robot.motor_to_v()[i]] = motor.dq;
    tau_est[i] = motor.tauEst;
  }
}

// The filter tracks the IMU's own point, where the accelerometer is right; the base's origin is an
// arm away from it.
void StateEstimator::Impl::place_base(const Vector3& f_base, double dt) noexcept {
  const Matrix3& R = dynamics.R_world_base();
  const Vector3 arm = R * robot.config().p_base_imu;
  const Vector3 arm_speed = dynamics.w_world_base().cross(arm);
  if (!started) {
    FeetMatrix p_feet;
    for (int leg = 0; leg < kLegs; ++leg) p_feet.col(leg) = dynamics.legs()[leg].p_world_contact;
    const Vector3 origin(0.0, 0.0, -p_feet.row(2).mean());
    filter.reset(origin + arm, p_feet.colwise() + origin);
    started = true;
  }
  filter.update(gains, R * f_base, arm, arm_speed, dynamics, state.contact, dt);
  const Vector3 p_base = filter.p_imu() - arm;
  const Vector3 v_base = filter.v_imu() - arm_speed;
  state.q.head<3>() = p_base;
  state.v.head<3>() = R.transpose() * v_base;
  dynamics.shift(p_base, v_base);
}

// At the IMU's own point: a + alpha x r + w x (v + w x r) less gravity is what it should feel.
void StateEstimator::Impl::observe_push(const Vector3& f_base, double dt) noexcept {
  // The plan already counts with what was believed of the push; that share is explained by it.
  const Vector3 believed = state.f_outside / robot.mass();
  state.f_outside.setZero();
  if (!has_plan) return;
  const Vector3 w = dynamics.w_base();
  const Vector3 r = robot.config().p_base_imu;
  const Vector3 v = state.v.head<3>();
  const Vector3 a = planned.head<3>() + planned.tail<3>().cross(r) + w.cross(v + w.cross(r));
  const Vector3 gravity = -kGravity * Vector3::UnitZ();
  push.update(gains, dynamics.R_world_base() * (f_base - a) + gravity + believed, dt);
  state.f_outside = robot.mass() * push.acceleration(gains);
}

}  // namespace surefoot
