// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/stand_controller.hpp"

#include "estimator/delay_predictor.hpp"
#include "low_state_check.hpp"
#include "reference/stand_reference.hpp"
#include "safety/command_keeper.hpp"
#include "safety/command_ladder.hpp"
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
        ladder(r),
        torques(r, o) {
    estimator.set_gains(g);
  }
  void adopt(const Gains& gains) noexcept {
    if (controller.adopt_gains(gains)) estimator.adopt_gains(gains);
  }
  Status think(const LowState& low_state, double dt) noexcept;
  Status solve_predicted(const Reference& wanted) noexcept;
  Status solve(const Dynamics& dynamics, const RobotState& state, const Reference& wanted) noexcept;
  void descend(const Dynamics& dynamics, const RobotState& state, const Reference& wanted) noexcept;
  const LowCmd& send(Status tick, double elapsed) noexcept;

  Robot robot;
  StandOptions options;
  TickClock clock;
  StateEstimator estimator;
  StandReference reference;
  DelayPredictor predictor;
  Dynamics predicted;  // at the state when the command acts
  WholeBodyController controller;
  CommandLadder ladder;
  TorqueCommand torques;
  CommandKeeper keeper;
  GainRamp ramp;
  double since_estimate = 0.0;  // [s]
  int latches = 0;
  Status status = Status::kWaiting;
  Status fault = Status::kOk;
  Rung rung = Rung::kDamping;
  std::array<std::uint64_t, kRungs> rung_counts{};
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
  s.rung = Rung::kHold;  // all there is, until the tick comes to its program
  if (s.keeper.latched()) {
    status = Status::kDamping;
  } else if (step >= 0.0) {
    status = s.think(low_state, std::min(s.since_estimate, TickClock::kMaxStep));
  }
  const LowCmd& command = s.send(status, elapsed);
  ++s.rung_counts[static_cast<int>(s.rung)];
  return command;
}

// A command that was solved, or what stands in for one, for as long as it may.
const LowCmd& StandController::Impl::send(Status tick, double elapsed) noexcept {
  const double kd = controller.gains().damping_kd;
  if (is_usable(tick)) {
    keeper.accept(torques.command());
  } else if (is_fresh(rung)) {
    keeper.bridge(torques.command(), elapsed, kd);
  } else {
    keeper.refuse(elapsed, kd);
  }
  if (!is_usable(tick) && tick != Status::kDamping) fault = tick;
  status = keeper.latched() ? Status::kDamping : tick;
  if (!keeper.controls()) rung = Rung::kDamping;
  if (is_fresh(rung)) {
    // What stands in for a solution makes the last one's motion, or nearly; torques that were
    // limited make as much less of it as they are nearer to holding.
    const LimitedTorques& sent = torques.limited();
    predictor.remember(controller.solution().accelerations, sent.scale, sent.torques);
  }
  return keeper.last();
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
  return predictor.active() ? solve_predicted(wanted) : solve(dynamics, estimator.state(), wanted);
}

Status StandController::Impl::solve_predicted(const Reference& wanted) noexcept {
  const RobotState& then = predictor.predict(estimator.state());
  predicted.update(then.q, then.v, wanted.ground_normal);
  return solve(predicted, then, wanted);
}

// The program, if need be anew from nothing, then the power that its torques may take.
Status StandController::Impl::solve(const Dynamics& dynamics, const RobotState& state,
                                    const Reference& wanted) noexcept {
  const Solution& solution = controller.solve(dynamics, state, wanted);
  rung = Rung::kSolved;
  if (!is_usable(solution.status)) {
    controller.solve_cold(dynamics);
    rung = Rung::kColdSolve;
  }
  if (is_usable(solution.status)) {
    ladder.remember(controller.gains(), dynamics, state, wanted, solution.forces);
    return torques.take(solution, dynamics, state, wanted, controller.gains());
  }
  descend(dynamics, state, wanted);
  return solution.status;
}

// Where there is no solution: torques without the program, within the same power.
void StandController::Impl::descend(const Dynamics& dynamics, const RobotState& state,
                                    const Reference& wanted) noexcept {
  const Gains& gains = controller.gains();
  rung = ladder.descend(gains, dynamics, state, wanted);
  if (rung == Rung::kHold) return;
  torques.take(ladder.torques(), ladder.damping(), dynamics, state, wanted, gains);
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
Rung StandController::rung() const noexcept { return impl_->rung; }
std::uint64_t StandController::rung_count(Rung rung) const noexcept {
  return impl_->rung_counts[static_cast<int>(rung)];
}
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
  impl_->ladder.set_torque_share(impl_->controller.torque_share());
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
  s.ladder.reset();
  s.torques.reset();
  s.keeper.reset();
  if (s.ramp.moving()) s.adopt(s.ramp.step(GainRamp::kTime));
  s.since_estimate = 0.0;
  s.latches = 0;
  s.status = Status::kWaiting;
  s.fault = Status::kOk;
  s.rung = Rung::kDamping;
}

}  // namespace surefoot
