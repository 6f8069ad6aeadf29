// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/controller.hpp"

#include "tick/controller_access.hpp"
#include "tick/controller_impl.hpp"

namespace surefoot {

Controller::Controller(const Robot& robot, std::shared_ptr<Planner> planner)
    : Controller(robot, std::move(planner), robot.config().gains) {}
Controller::Controller(const Robot& robot, std::shared_ptr<Planner> planner, const Gains& gains,
                       const ControllerOptions& options)
    : impl_(std::make_unique<Impl>(robot, std::move(planner), gains, options)) {}
Controller::~Controller() = default;
Controller::Controller(Controller&&) noexcept = default;

const LowCmd& Controller::update(const LowState& low_state) noexcept {
  return impl_->tick(low_state);
}

Status Controller::status() const noexcept { return impl_->status; }
Status Controller::fault() const noexcept { return impl_->fault; }
FallbackLevel Controller::fallback_level() const noexcept { return impl_->fallback_level; }
std::uint64_t Controller::fallback_count(FallbackLevel fallback_level) const noexcept {
  return impl_->fallback_counts[static_cast<int>(fallback_level)];
}
const RobotState& Controller::state() const noexcept { return impl_->state; }
EstimatorReport Controller::estimator_report() const noexcept { return impl_->estimator.report(); }
const Reference& Controller::reference() const noexcept { return impl_->planned.reference(); }
const Solution& Controller::solution() const noexcept { return impl_->controller.solution(); }
const QpProblem& Controller::qp() const noexcept { return impl_->controller.qp(); }
bool Controller::has_foot_force_est() const noexcept {
  return impl_->estimator.has_foot_force_est();
}
Eigen::Vector4d Controller::normal_forces_from_torques() const noexcept {
  return impl_->estimator.normal_forces_from_torques();
}
double Controller::command_power() const noexcept { return impl_->torque_command.limited().power; }
double Controller::power_scale() const noexcept { return impl_->torque_command.limited().scale; }
void Controller::declare_leg_lost(int leg) noexcept {
  if (leg >= 0 && leg < kLegs && lost_leg() < 0) impl_->lost_leg = leg;
}
int Controller::lost_leg() const noexcept { return impl_->lost_leg; }
void Controller::set_torque_share(const Vector12& share) noexcept {
  impl_->controller.set_torque_share(share);
  impl_->fallback_chain.set_torque_share(impl_->controller.torque_share());
  impl_->torque_command.set_torque_share(impl_->controller.torque_share());
}
void Controller::add_task(std::shared_ptr<Task> task) {
  impl_->controller.add_task(std::move(task));
}
const Gains& Controller::gains() const noexcept {
  return impl_->gain_ramp.moving() ? impl_->gain_ramp.target() : impl_->controller.gains();
}
const Gains& Controller::active_gains() const noexcept { return impl_->controller.gains(); }

void Controller::set_gains(const Gains& gains) {
  gains.validate();
  Impl& s = *impl_;
  // A caller may set the same gains in every tick; this must not restart the ramp.
  if (gains == this->gains()) return;
  s.gain_ramp.start(s.controller.gains(), gains);
  if (!s.started || s.command_hold.latched())
    s.apply_gains(s.gain_ramp.step(GainChangeRamp::kRampTime));
}

void ControllerAccess::end_sensor_check(Controller& controller) noexcept {
  controller.impl_->sensor_check.end();
}
const Dynamics& ControllerAccess::dynamics(const Controller& controller) noexcept {
  return controller.impl_->estimator.dynamics();
}

void Controller::reset() noexcept {
  Impl& s = *impl_;
  s.clock.reset();
  s.estimator.reset();
  s.sensor_check.reset();
  s.state = s.estimator.state();
  s.planned.reset();
  s.lost_leg = -1;
  s.friction.reset();
  s.controller.reset();
  s.predictor.reset();
  s.fallback_chain.reset();
  s.torque_command.reset();
  s.command_hold.reset();
  if (s.gain_ramp.moving()) s.apply_gains(s.gain_ramp.step(GainChangeRamp::kRampTime));
  s.time_since_estimate = 0.0;
  s.started = false;
  s.status = Status::kWaiting;
  s.fault = Status::kOk;
  s.fallback_level = FallbackLevel::kDamping;
}

}  // namespace surefoot
