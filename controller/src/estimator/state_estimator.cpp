// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/state_estimator.hpp"

#include "estimator/estimator_impl.hpp"
#include "low_level/low_state_check.hpp"
#include "surefoot/stage_clock.hpp"

namespace surefoot {

namespace {
// [s] Longest time step for one sample. Chosen longer than 0.01 s, the period at 100 Hz, and at
// most 0.1 s, the time without a sample after which the controller damps (kRobotWatchdogTime).
constexpr double kMaxTimeStep = 0.1;
}  // namespace

StateEstimator::StateEstimator(const Robot& robot) : impl_(std::make_unique<Impl>(robot)) {}
StateEstimator::~StateEstimator() = default;
StateEstimator::StateEstimator(StateEstimator&&) noexcept = default;

const RobotState& StateEstimator::state() const noexcept { return impl_->state; }
const Dynamics& StateEstimator::dynamics() const noexcept { return impl_->dynamics; }
bool StateEstimator::has_foot_force_est() const noexcept {
  return impl_->contact.foot_force_est_works();
}
double StateEstimator::ground_friction() const noexcept { return impl_->friction.coefficient(); }
Eigen::Vector4d StateEstimator::normal_forces_from_torques() const noexcept {
  return impl_->leg_forces.forces().transpose() * impl_->normal;
}

Eigen::Vector4d StateEstimator::sole_sink() const noexcept { return impl_->sole_sink(); }

void StateEstimator::set_gains(const Gains& gains) {
  gains.validate();
  impl_->gains = gains;
}

bool StateEstimator::adopt_gains(const Gains& gains) noexcept {
  if (!gains.valid()) return false;
  impl_->gains = gains;
  return true;
}

void StateEstimator::set_ground_normal(const Vector3& normal) noexcept {
  // With another ground normal, a foot touches the ground at another point of its sphere. So the
  // contact points move, although the feet do not.
  const Vector3 displacement = -impl_->robot.config().foot_radius * (normal - impl_->normal);
  if (impl_->started) impl_->filter.move_feet(displacement.replicate<1, kLegs>());
  impl_->normal = normal;
}

void StateEstimator::set_planned_motion(const Vector6& a_base, const Vector12& tau,
                                        const Vector3& f_push) noexcept {
  impl_->planned_acceleration = a_base;
  impl_->planned_push = f_push;
  impl_->planned_tau = tau;
  impl_->has_plan = true;
}

void StateEstimator::set_stepping(bool stepping) noexcept {
  impl_->step_detector.set_planned(stepping);
}

void StateEstimator::reset() noexcept { impl_->reset(); }

Status StateEstimator::update(const LowState& low_state, double dt) noexcept {
  const StageScope stage(Stage::kEstimate);
  Impl& s = *impl_;
  if (!(dt > 0.0 && dt <= kMaxTimeStep)) return Status::kStaleTick;
  const Status status = check_low_state(low_state, s.robot.config());
  if (status != Status::kOk) return status;
  s.read_joints(low_state);
  const Vector12 joints = s.state.q.tail<kMotors>() + s.state.v.tail<kMotors>();
  s.imu_reader.read(low_state.imu, s.robot.config(), joints, dt, s.imu);
  s.torque_check.update(s.tau_est, s.imu.changed, dt);
  if (!s.started) s.initialise();
  s.predict(dt);
  s.update_dynamics();
  s.update_contacts(low_state, dt);
  s.correct(dt);
  s.observe_external_wrench(dt);
  if (s.filter.is_plausible()) return Status::kOk;
  s.reset();
  return Status::kDiverged;
}

}  // namespace surefoot
