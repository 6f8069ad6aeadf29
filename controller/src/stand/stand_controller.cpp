// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stand_controller.hpp"

#include <cmath>

#include "reference/capture_margin.hpp"
#include "stand/stand_controller_access.hpp"
#include "stand/stand_controller_impl.hpp"

namespace surefoot {

StandController::StandController(const Robot& robot)
    : StandController(robot, robot.config().gains) {}
StandController::StandController(const Robot& robot, const Gains& gains,
                                 const StandOptions& options)
    : impl_(std::make_unique<Impl>(robot, gains, options)) {}
StandController::~StandController() = default;
StandController::StandController(StandController&&) noexcept = default;

const LowCmd& StandController::update(const LowState& low_state) noexcept {
  return impl_->tick(low_state);
}

Status StandController::status() const noexcept { return impl_->status; }
Status StandController::fault() const noexcept { return impl_->fault; }
FallbackLevel StandController::fallback_level() const noexcept { return impl_->fallback_level; }
std::uint64_t StandController::fallback_count(FallbackLevel fallback_level) const noexcept {
  return impl_->fallback_counts[static_cast<int>(fallback_level)];
}
const RobotState& StandController::state() const noexcept { return impl_->state; }
EstimatorReport StandController::estimator_report() const noexcept {
  return impl_->estimator.report();
}
const Reference& StandController::reference() const noexcept {
  return impl_->reference.reference();
}
const Solution& StandController::solution() const noexcept { return impl_->controller.solution(); }
const QpProblem& StandController::qp() const noexcept { return impl_->controller.qp(); }
bool StandController::has_foot_force_est() const noexcept {
  return impl_->estimator.has_foot_force_est();
}
Eigen::Vector4d StandController::normal_forces_from_torques() const noexcept {
  return impl_->estimator.normal_forces_from_torques();
}
double StandController::command_power() const noexcept {
  return impl_->torque_command.limited().power;
}
double StandController::power_scale() const noexcept {
  return impl_->torque_command.limited().scale;
}
void StandController::set_body_reference(const BodyReference& target) noexcept {
  impl_->reference.set_target(target);
}
BodyReference StandController::body_reference() const noexcept {
  return impl_->reference.motion().relative_pose();
}
ReachStatus StandController::reach() const noexcept { return impl_->reference.motion().status(); }
void StandController::declare_leg_lost(int leg) noexcept {
  if (leg >= 0 && leg < kLegs && lost_leg() < 0) impl_->reference.declare_leg_lost(leg);
}
int StandController::lost_leg() const noexcept { return impl_->reference.lost_leg(); }
double StandController::capture_margin_without(int leg) const noexcept {
  if (leg < 0 || leg >= kLegs || impl_->pose_latches == 0) return std::nan("");
  std::array<bool, kLegs> stance = {true, true, true, true};
  stance[leg] = false;
  if (lost_leg() >= 0) stance[lost_leg()] = false;
  return capture_margin(impl_->estimator.dynamics(), stance);
}
void StandController::set_torque_share(const Vector12& share) noexcept {
  impl_->controller.set_torque_share(share);
  impl_->fallback_chain.set_torque_share(impl_->controller.torque_share());
  impl_->torque_command.set_torque_share(impl_->controller.torque_share());
}
void StandController::add_task(std::shared_ptr<Task> task) {
  impl_->controller.add_task(std::move(task));
}
const Gains& StandController::gains() const noexcept {
  return impl_->gain_ramp.moving() ? impl_->gain_ramp.target() : impl_->controller.gains();
}
const Gains& StandController::active_gains() const noexcept { return impl_->controller.gains(); }

void StandController::set_gains(const Gains& gains) {
  gains.validate();
  Impl& s = *impl_;
  // A caller may set the same gains in every tick; this must not restart the ramp.
  if (gains == this->gains()) return;
  s.gain_ramp.start(s.controller.gains(), gains);
  if (s.pose_latches == 0 || s.command_hold.latched())
    s.apply_gains(s.gain_ramp.step(GainChangeRamp::kRampTime));
}

void StandControllerAccess::end_sensor_check(StandController& controller) noexcept {
  controller.impl_->sensor_check.end();
}

void StandController::reset() noexcept {
  Impl& s = *impl_;
  s.clock.reset();
  s.estimator.reset();
  s.sensor_check.reset();
  s.state = s.estimator.state();
  s.reference.reset();
  s.friction.reset();
  s.controller.reset();
  s.predictor.reset();
  s.fallback_chain.reset();
  s.torque_command.reset();
  s.command_hold.reset();
  if (s.gain_ramp.moving()) s.apply_gains(s.gain_ramp.step(GainChangeRamp::kRampTime));
  s.time_since_estimate = 0.0;
  s.pose_latches = 0;
  s.status = Status::kWaiting;
  s.fault = Status::kOk;
  s.fallback_level = FallbackLevel::kDamping;
}

}  // namespace surefoot
