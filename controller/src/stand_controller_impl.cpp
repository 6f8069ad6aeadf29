// SPDX-License-Identifier: BSD-3-Clause
#include "stand_controller_impl.hpp"

#include "low_state_check.hpp"
#include "surefoot/error.hpp"

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

StandController::Impl::Impl(const Robot& r, const Gains& g, const StandOptions& o)
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
  state = estimator.state();  // of its size, that no tick allocates
}

void StandController::Impl::adopt(const Gains& gains) noexcept {
  if (controller.adopt_gains(gains)) estimator.adopt_gains(gains);
}

const LowCmd& StandController::Impl::tick(const LowState& low_state) noexcept {
  const double step = clock.advance(low_state.tick);
  // Who was away for long commands a robot that has damped by itself, and is elsewhere by now.
  const bool away = step > 0.0 && clock.gap() > kAwayTime;
  const double elapsed = away ? clock.gap() : step > 0.0 ? step : clock.period();
  // Time in bad reports is not lost to the estimator; a tick that stands still adds none, for the
  // next good one counts from the last.
  if (step >= 0.0) {
    since_estimate += elapsed;
    predictor.elapse(elapsed);
  }
  Status status = Status::kStaleTick;
  rung = Rung::kHold;  // all there is, until the tick comes to its program
  if (keeper.latched()) {
    status = Status::kDamping;
    if (ramp.moving()) adopt(ramp.step(GainRamp::kTime));
  } else if (step >= 0.0 && !(away && keeper.controls())) {
    status = think(low_state, std::min(since_estimate, TickClock::kMaxStep));
  }
  // An estimate that begins anew is no longer the one that the reference was latched by.
  const LowCmd& command = send(status, status == Status::kDiverged ? kAwayTime : elapsed);
  ++rung_counts[static_cast<int>(rung)];
  return command;
}

// A command that was solved, or what stands in for one, for as long as it may.
const LowCmd& StandController::Impl::send(Status tick, double elapsed) noexcept {
  const double kd = controller.gains().damping_kd;
  if (is_usable(tick)) {
    keeper.accept(torques.command(elapsed));
  } else if (is_fresh(rung)) {
    keeper.bridge(torques.command(elapsed), elapsed, kd);
  } else {
    keeper.refuse(elapsed, kd);
  }
  if (!is_usable(tick) && tick != Status::kDamping) fault = tick;
  status = keeper.latched() ? Status::kDamping : tick;
  if (!keeper.controls()) rung = Rung::kDamping;
  if (is_fresh(rung)) {
    // What stands in for a solution makes the last one's motion, or nearly; torques that were
    // limited make as much less of it as they are nearer to holding. A leg that is flung makes less
    // of its share, for as long as its foot gives no hold anyway.
    const LimitedTorques& sent = torques.limited();
    predictor.remember(controller.solution().accelerations, sent.scale, sent.torques,
                       state.f_outside - state.f_lasting);
  }
  return keeper.last();
}

// Estimate, refer, solve: each stage hands one struct to the next.
Status StandController::Impl::think(const LowState& low_state, double dt) noexcept {
  // A robot that stands goes on without the vendor's attitude; none is started without it.
  if (latches == 0 && !has_quaternion(low_state.imu)) return Status::kBadQuaternion;
  const SentCommand* acting = predictor.acting(clock.period());
  if (acting != nullptr) {
    estimator.set_plan(acting->accelerations.head<6>(), acting->tau, acting->f_push);
  }
  const Status estimated = estimator.update(low_state, dt);
  state = estimator.state();
  if (estimated != Status::kOk) return estimated;
  since_estimate = 0.0;
  torques.watch(state, dt);
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
  torques.set_lost_leg(reference.lost_leg());
  if (predictor.active()) return solve_predicted(wanted, dt);
  state.friction = friction.update(dynamics, state, wanted, robot.mass(), dt);
  return solve(dynamics, state, wanted);
}

Status StandController::Impl::solve_predicted(const Reference& wanted, double dt) noexcept {
  RobotState& ahead = predictor.predict(state);
  predicted.update(ahead.q, ahead.v, wanted.ground_normal);
  ahead.friction = state.friction = friction.update(predicted, ahead, wanted, robot.mass(), dt);
  return solve(predicted, ahead, wanted);
}

// The program, if need be anew from nothing, then the power that its torques may take.
Status StandController::Impl::solve(const Dynamics& dynamics, const RobotState& now,
                                    const Reference& wanted) noexcept {
  const Solution& solution = controller.solve(dynamics, now, wanted);
  rung = Rung::kSolved;
  if (!is_usable(solution.status)) {
    controller.solve_cold(dynamics);
    rung = Rung::kColdSolve;
  }
  if (is_usable(solution.status)) {
    ladder.remember(controller.gains(), dynamics, now, wanted, solution.forces);
    return torques.take(solution, dynamics, now, wanted, controller.gains());
  }
  descend(dynamics, now, wanted);
  return solution.status;
}

// Where there is no solution: torques without the program, within the same power.
void StandController::Impl::descend(const Dynamics& dynamics, const RobotState& now,
                                    const Reference& wanted) noexcept {
  const Gains& gains = controller.gains();
  rung = ladder.descend(gains, dynamics, now, wanted);
  if (rung == Rung::kHold) return;
  torques.take(ladder.torques(), ladder.damping(), dynamics, now, wanted, gains);
}

}  // namespace surefoot
