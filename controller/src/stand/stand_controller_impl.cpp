// SPDX-License-Identifier: BSD-3-Clause
#include "stand/stand_controller_impl.hpp"

#include "low_level/low_state_check.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

namespace {

constexpr int kPoseLatches = 3;

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
      predicted_dynamics(r),
      controller(r, g, WholeBodyOptions{o.form}),
      fallback_chain(r),
      torque_command(r, o.motor_damping, o.power_limit) {
  estimator.set_gains(g);
  state = estimator.state();  // of its size, that no tick allocates
}

void StandController::Impl::apply_gains(const Gains& gains) noexcept {
  if (controller.adopt_gains(gains)) estimator.adopt_gains(gains);
}

const LowCmd& StandController::Impl::tick(const LowState& low_state) noexcept {
  const double step = clock.advance(low_state.tick);
  // Who was away for long commands a robot that has damped by itself, and is elsewhere by now.
  const bool robot_timed_out = step > 0.0 && clock.gap() > kRobotWatchdogTime;
  const double elapsed = robot_timed_out ? clock.gap() : step > 0.0 ? step : clock.period();
  // Time in bad reports is not lost to the estimator; a tick that stands still adds none, for the
  // next good one counts from the last.
  if (step >= 0.0) {
    time_since_estimate += elapsed;
    predictor.advance(elapsed);
  }
  Status status = Status::kStaleTick;
  fallback_level = FallbackLevel::kHold;  // all there is, until the tick comes to its program
  if (command_hold.latched()) {
    status = Status::kDamping;
    if (gain_ramp.moving()) apply_gains(gain_ramp.step(GainRamp::kRampTime));
  } else if (step >= 0.0 && !(robot_timed_out && command_hold.in_control())) {
    status = estimate_and_solve(low_state, std::min(time_since_estimate, TickClock::kMaxStep));
  }
  // An estimate that begins anew is no longer the one that the reference was latched by.
  const LowCmd& command =
      select_command(status, status == Status::kDiverged ? kRobotWatchdogTime : elapsed);
  ++fallback_counts[static_cast<int>(fallback_level)];
  return command;
}

// A command that was solved, or what stands in for one, for as long as it may.
const LowCmd& StandController::Impl::select_command(Status tick, double elapsed) noexcept {
  const double kd = controller.gains().damping_kd;
  if (is_usable(tick)) {
    command_hold.accept(torque_command.command(elapsed));
  } else if (is_fresh(fallback_level)) {
    command_hold.substitute(torque_command.command(elapsed), elapsed, kd);
  } else {
    command_hold.repeat_or_damp(elapsed, kd);
  }
  if (!is_usable(tick) && tick != Status::kDamping) fault = tick;
  status = command_hold.latched() ? Status::kDamping : tick;
  if (!command_hold.in_control()) fallback_level = FallbackLevel::kDamping;
  if (is_fresh(fallback_level)) {
    // What stands in for a solution makes the last one's motion, or nearly; torques that were
    // limited make as much less of it as they are nearer to holding. A leg that is flung makes less
    // of its share, for as long as its foot gives no hold anyway.
    const LimitedTorques& sent = torque_command.limited();
    predictor.record(controller.solution().accelerations, sent.scale, sent.torques,
                     state.f_external - state.f_sustained);
  }
  return command_hold.last();
}

// Estimate, refer, solve: each stage hands one struct to the next.
Status StandController::Impl::estimate_and_solve(const LowState& low_state, double dt) noexcept {
  // A robot that stands goes on without the vendor's attitude; none is started without it.
  if (pose_latches == 0 && !has_unit_quaternion(low_state.imu)) return Status::kBadQuaternion;
  const SentCommand* acting_command = predictor.acting_command(clock.period());
  if (acting_command != nullptr) {
    estimator.set_planned_motion(acting_command->accelerations.head<6>(), acting_command->tau,
                                 acting_command->f_push);
  }
  const Status estimated = estimator.update(low_state, dt);
  state = estimator.state();
  if (estimated != Status::kOk) return estimated;
  time_since_estimate = 0.0;
  torque_command.observe_joints(state, dt);
  if (gain_ramp.moving()) apply_gains(gain_ramp.step(dt));
  const Dynamics& dynamics = estimator.dynamics();
  const Eigen::Vector4d& contact = estimator.state().contact;
  if (dynamics.R_world_base()(2, 2) < std::cos(controller.gains().fall_tilt)) {
    return Status::kFallen;
  }
  // The contact points hang on the ground's normal, which is known once they are: latch a few
  // times.
  if (pose_latches < kPoseLatches) {
    reference.latch(dynamics, estimator.state().q);
    ++pose_latches;
  }
  const Reference& desired = reference.update(controller.gains(), dynamics, contact, dt);
  estimator.set_ground_normal(desired.ground_normal);
  torque_command.set_lost_leg(reference.lost_leg());
  if (predictor.active()) return solve_predicted(desired, dt);
  state.friction = friction.update(dynamics, state, desired, robot.mass(), dt);
  return solve(dynamics, state, desired);
}

Status StandController::Impl::solve_predicted(const Reference& desired, double dt) noexcept {
  RobotState& predicted_state = predictor.predict(state);
  predicted_dynamics.update(predicted_state.q, predicted_state.v, desired.ground_normal);
  predicted_state.friction = state.friction =
      friction.update(predicted_dynamics, predicted_state, desired, robot.mass(), dt);
  return solve(predicted_dynamics, predicted_state, desired);
}

// The program, if need be anew from nothing, then the power that its torques may take.
Status StandController::Impl::solve(const Dynamics& dynamics, const RobotState& used_state,
                                    const Reference& desired) noexcept {
  const Solution& solution = controller.solve(dynamics, used_state, desired);
  fallback_level = FallbackLevel::kSolved;
  if (!is_usable(solution.status)) {
    controller.solve_cold(dynamics);
    fallback_level = FallbackLevel::kColdSolve;
  }
  if (is_usable(solution.status)) {
    fallback_chain.remember(controller.gains(), dynamics, used_state, desired, solution.forces);
    return torque_command.take(solution, dynamics, used_state, desired, controller.gains());
  }
  compute_fallback(dynamics, used_state, desired);
  return solution.status;
}

// Where there is no solution: torques without the program, within the same power.
void StandController::Impl::compute_fallback(const Dynamics& dynamics, const RobotState& used_state,
                                             const Reference& desired) noexcept {
  const Gains& gains = controller.gains();
  fallback_level = fallback_chain.compute_fallback(gains, dynamics, used_state, desired);
  if (fallback_level == FallbackLevel::kHold) return;
  torque_command.take(fallback_chain.torques(), fallback_chain.damping(), dynamics, used_state,
                      desired, gains);
}

}  // namespace surefoot
