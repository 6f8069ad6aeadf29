// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stand_controller.hpp"

#include "estimator/delay_predictor.hpp"
#include "low_state_check.hpp"
#include "reference/stand_reference.hpp"
#include "safety/command_keeper.hpp"
#include "safety/gain_ramp.hpp"
#include "safety/tick_clock.hpp"
#include "safety/torque_command.hpp"
#include "surefoot/error.hpp"
#include "surefoot/state_estimator.hpp"
#include "surefoot/whole_body_controller.hpp"

namespace surefoot {

namespace {

constexpr int kLatches = 3;

const Robot& twelve_joints(const Robot& robot) {
  if (robot.nv() == 6 + kMotors && robot.nq() == 7 + kMotors) return robot;
  throw Error("robot '" + robot.config().name + "': got nq = " + std::to_string(robot.nq()) +
              ", nv = " + std::to_string(robot.nv()) +
              ", expected 19 and 18 for a StandController: LowState reports twelve joints; make "
              "others fixed, or use WholeBodyController with a state of your own");
}

}  // namespace

struct StandController::Impl {
  Impl(const Robot& r, const Gains& g, const StandOptions& o)
      : robot(twelve_joints(r)),
        options((o.validate(), o)),
        estimator(r),
        reference(r),
        predictor(r.nv(), o.delay),
        predicted(r),
        controller(r, g, WholeBodyOptions{o.form}),
        torques(r, o) {
    estimator.set_gains(g);
  }
  void adopt(const Gains& gains) noexcept {
    if (controller.adopt_gains(gains)) estimator.adopt_gains(gains);
  }
  Status think(const LowState& low_state, double dt) noexcept;
  Status solve_predicted(const Reference& wanted) noexcept;
  Status solve(const Dynamics& dynamics, const RobotState& state, const Reference& wanted) noexcept;

  Robot robot;
  StandOptions options;
  TickClock clock;
  StateEstimator estimator;
  StandReference reference;
  DelayPredictor predictor;
  Dynamics predicted;  // at the state when the command acts
  WholeBodyController controller;
  TorqueCommand torques;
  CommandKeeper keeper;
  GainRamp ramp;
  double since_estimate = 0.0;  // [s]
  int latches = 0;
  Status status = Status::kWaiting;
  Status fault = Status::kOk;
};

const LowCmd& StandController::update(const LowState& low_state) noexcept {
  Impl& s = *impl_;
  const double step = s.clock.advance(low_state.tick);
  const double elapsed = step > 0.0 ? step : s.clock.period();
  // Time in bad reports is not lost to the estimator; a tick that stands still adds none, for the
  // next good one counts from the last.
  if (step >= 0.0) {
    s.since_estimate += elapsed;
    s.predictor.elapse(elapsed);
  }
  Status status = Status::kStaleTick;
  if (s.keeper.latched()) {
    status = Status::kDamping;
  } else if (step >= 0.0) {
    status = s.think(low_state, std::min(s.since_estimate, TickClock::kMaxStep));
  }
  if (is_usable(status)) {
    s.status = status;
    return s.keeper.accept(s.torques.command());
  }
  if (status != Status::kDamping) s.fault = status;
  const LowCmd& command = s.keeper.refuse(elapsed, s.controller.gains().damping_kd);
  s.status = s.keeper.latched() ? Status::kDamping : status;
  return command;
}

// Estimate, refer, solve: each stage hands one struct to the next.
Status StandController::Impl::think(const LowState& low_state, double dt) noexcept {
  // A robot that stands goes on without the vendor's attitude; none is started without it.
  if (latches == 0 && !has_quaternion(low_state.imu)) return Status::kBadQuaternion;
  const SentCommand* acting = predictor.acting();
  if (acting != nullptr) estimator.set_plan(acting->accelerations.head<6>(), acting->tau);
  const Status estimated = estimator.update(low_state, dt);
  if (estimated != Status::kOk) return estimated;
  since_estimate = 0.0;
  if (ramp.moving()) adopt(ramp.step(dt));
  const Dynamics& dynamics = estimator.dynamics();
  const Eigen::Vector4d& contact = estimator.state().contact;
  if (dynamics.R_world_base()(2, 2) < std::cos(controller.gains().fall_tilt)) {
    return Status::kFallen;
  }
  // The contact points hang on the ground's normal, which is known once they are: latch a few
  // times.
  if (latches < kLatches) {
    reference.latch(dynamics, estimator.state().q);
    ++latches;
  }
  const Reference& wanted = reference.update(controller.gains(), dynamics, contact, dt);
  estimator.set_ground_normal(wanted.ground_normal);
  const Status solved =
      predictor.active() ? solve_predicted(wanted) : solve(dynamics, estimator.state(), wanted);
  if (is_usable(solved)) {
    // Torques that were limited make as much less of the motion as they are nearer to holding.
    const LimitedTorques& sent = torques.limited();
    predictor.remember(controller.solution().accelerations, sent.scale, sent.torques);
  }
  return solved;
}

Status StandController::Impl::solve_predicted(const Reference& wanted) noexcept {
  const RobotState& then = predictor.predict(estimator.state());
  predicted.update(then.q, then.v, wanted.ground_normal);
  return solve(predicted, then, wanted);
}

// The program, then the power that its torques may take.
Status StandController::Impl::solve(const Dynamics& dynamics, const RobotState& state,
                                    const Reference& wanted) noexcept {
  const Solution& solution = controller.solve(dynamics, state, wanted);
  if (!is_usable(solution.status)) return solution.status;
  return torques.take(solution, dynamics, state, wanted, controller.gains());
}

StandController::StandController(const Robot& robot)
    : StandController(robot, robot.config().gains) {}
StandController::StandController(const Robot& robot, const Gains& gains,
                                 const StandOptions& options)
    : impl_(std::make_unique<Impl>(robot, gains, options)) {}
StandController::~StandController() = default;
StandController::StandController(StandController&&) noexcept = default;

Status StandController::status() const noexcept { return impl_->status; }
Status StandController::fault() const noexcept { return impl_->fault; }
const RobotState& StandController::state() const noexcept { return impl_->estimator.state(); }
EstimatorReport StandController::estimator_report() const noexcept {
  return impl_->estimator.report();
}
const Reference& StandController::reference() const noexcept {
  return impl_->reference.reference();
}
const Solution& StandController::solution() const noexcept { return impl_->controller.solution(); }
const QpProblem& StandController::program() const noexcept { return impl_->controller.program(); }
bool StandController::foot_force_alive() const noexcept {
  return impl_->estimator.foot_force_alive();
}
Eigen::Vector4d StandController::torque_force() const noexcept {
  return impl_->estimator.torque_force();
}
double StandController::power() const noexcept { return impl_->torques.limited().power; }
double StandController::power_scale() const noexcept { return impl_->torques.limited().scale; }
void StandController::set_body_reference(const BodyReference& target) noexcept {
  impl_->reference.set_target(target);
}
BodyReference StandController::body_reference() const noexcept {
  return impl_->reference.motion().position();
}
ReachStatus StandController::reach() const noexcept { return impl_->reference.motion().status(); }
void StandController::set_torque_share(const Vector12& share) noexcept {
  impl_->controller.set_torque_share(share);
}
void StandController::add_task(std::shared_ptr<Task> task) {
  impl_->controller.add_task(std::move(task));
}
const Gains& StandController::gains() const noexcept {
  return impl_->ramp.moving() ? impl_->ramp.target() : impl_->controller.gains();
}
const Gains& StandController::gains_in_force() const noexcept { return impl_->controller.gains(); }

void StandController::set_gains(const Gains& gains) {
  gains.validate();
  Impl& s = *impl_;
  // Asked for again on their way, they go on: a caller may do so every tick.
  if (gains == this->gains()) return;
  s.ramp.start(s.controller.gains(), gains);
  if (s.latches == 0 || s.keeper.latched()) s.adopt(s.ramp.step(GainRamp::kTime));
}

void StandController::reset() noexcept {
  Impl& s = *impl_;
  s.clock.reset();
  s.estimator.reset();
  s.reference.reset();
  s.controller.reset();
  s.predictor.reset();
  s.torques.reset();
  s.keeper.reset();
  if (s.ramp.moving()) s.adopt(s.ramp.step(GainRamp::kTime));
  s.since_estimate = 0.0;
  s.latches = 0;
  s.status = Status::kWaiting;
  s.fault = Status::kOk;
}

}  // namespace surefoot
