// SPDX-License-Identifier: BSD-3-Clause
#include "tick/controller_impl.hpp"

#include "low_level/low_state_check.hpp"
#include "reference/planner_input.hpp"
#include "surefoot/error.hpp"
#include "tick/unloaded_feet.hpp"

namespace surefoot {

namespace {

// [N] Contact forces below this are none: the robot is in the air, or no QP has been solved yet.
constexpr double kNoForce = 1e-6;

const Robot& require_twelve_joints(const Robot& robot) {
  if (robot.nv() == 6 + kMotors && robot.nq() == 7 + kMotors) return robot;
  throw Error("robot '" + robot.config().name + "': got nq = " + std::to_string(robot.nq()) +
              ", nv = " + std::to_string(robot.nv()) +
              ", expected 19 and 18 for a Controller: a LowState has twelve joints; make "
              "other joints fixed, or use a WholeBodyController with your own state");
}

}  // namespace

Controller::Impl::Impl(const Robot& r, std::shared_ptr<Planner> p, const Gains& g,
                       const ControllerOptions& o)
    : robot(require_twelve_joints(r)),
      options((o.validate(), o)),
      estimator(r),
      sensor_check(r),
      planned(r, std::move(p)),
      predictor(r.nv(), o.delay),
      predicted_dynamics(r),
      controller(r, g, WholeBodyOptions{o.form}),
      fallback_chain(r),
      torque_command(r, o.motor_damping, o.power_limit) {
  estimator.set_gains(g);
  // These give vectors their sizes, so that ticks do not allocate.
  state = estimator.state();
  motion.setZero(r.nv());
}

void Controller::Impl::apply_gains(const Gains& gains) noexcept {
  if (controller.adopt_gains(gains)) estimator.adopt_gains(gains);
}

const LowCmd& Controller::Impl::tick(const LowState& low_state) noexcept {
  const double step = clock.advance(low_state.tick);
  // After a gap of more than 100 ms the robot has already damped by itself, so the old plan is no
  // longer valid: latch damping.
  const bool robot_timed_out = step > 0.0 && clock.gap() > kRobotWatchdogTime;
  const double elapsed = robot_timed_out ? clock.gap() : step > 0.0 ? step : clock.period();
  // The next estimate also covers the time of unusable samples. A sample whose tick repeats, runs
  // backwards or jumps (step < 0) adds no time here, because the clock measures the step of the
  // next good tick from the last good tick.
  if (step >= 0.0) {
    time_since_estimate += elapsed;
    predictor.advance(elapsed);
  }
  Status status = Status::kStaleTick;
  fallback_level = FallbackLevel::kHold;  // value until this tick computes a command
  if (command_hold.latched()) {
    status = Status::kDamping;
    if (gain_ramp.moving()) apply_gains(gain_ramp.step(GainChangeRamp::kRampTime));
  } else if (step >= 0.0 && !(robot_timed_out && command_hold.in_control())) {
    status = estimate_and_solve(low_state, std::min(time_since_estimate, TickClock::kMaxStep));
  }
  // After a divergence the estimator starts again, and the latched reference does not fit the new
  // estimate. So damping must be latched at once: an elapsed time of 100 ms, longer than kHoldTime,
  // makes the command hold do this.
  const LowCmd& command =
      select_command(status, status == Status::kDiverged ? kRobotWatchdogTime : elapsed);
  ++fallback_counts[static_cast<int>(fallback_level)];
  return command;
}

// Choose the command to send: solved, computed without the QP, repeated, or damping. Record it in
// the predictor if it is a new command.
const LowCmd& Controller::Impl::select_command(Status tick, double elapsed) noexcept {
  const double kd = controller.gains().damping_kd;
  if (is_usable(tick)) {
    command_hold.accept(torque_command.command(elapsed));
  } else if (is_fresh(fallback_level)) {
    command_hold.substitute(torque_command.command(elapsed), elapsed, kd);
  } else if (names_wrong_sensor(tick)) {
    command_hold.latch(kd);
  } else {
    command_hold.repeat_or_damp(elapsed, kd);
  }
  if (!is_usable(tick) && tick != Status::kDamping) fault = tick;
  status = command_hold.latched() ? Status::kDamping : tick;
  if (!command_hold.in_control()) fallback_level = FallbackLevel::kDamping;
  if (is_fresh(fallback_level)) {
    const LimitedTorques& sent = torque_command.limited();
    predictor.record(limited_motion(sent), sent.torques,
                     sent.scale * (state.f_external - state.f_sustained));
  }
  return command_hold.last();
}

// Return the accelerations that limited torques cause. A fallback command causes about the motion
// of the last solution. If the power limit scales torques, their motion is scaled by the same
// factor. A runaway leg whose torques are limited moves less; this error is neglected, because its
// foot carries no load.
const Eigen::VectorXd& Controller::Impl::limited_motion(const LimitedTorques& sent) noexcept {
  motion = sent.scale * controller.solution().accelerations;
  for (int i = 0; i < kMotors; ++i) {
    const int v = robot.motor_to_v()[i];
    if (sent.swings[i / kLegJoints])
      motion[v] = sent.swing_scale * controller.solution().accelerations[v];
  }
  return motion;
}

// Estimate the state, plan the reference and solve the QP.
Status Controller::Impl::estimate_and_solve(const LowState& low_state, double dt) noexcept {
  // Only the first estimate needs the quaternion of the IMU. A standing robot continues without a
  // quaternion.
  if (!started && !has_unit_quaternion(low_state.imu)) return Status::kBadQuaternion;
  const SentCommand* acting_command = predictor.acting_command(clock.period());
  if (acting_command != nullptr) {
    estimator.set_planned_motion(acting_command->accelerations.head<6>(), acting_command->tau,
                                 acting_command->f_push);
  }
  const Status estimator_status = estimator.update(low_state, dt);
  // The samples of a lost leg's motors may be wrong.
  const Status wrong_sensor =
      lost_leg >= 0
          ? Status::kOk
          : sensor_check.update(low_state, estimator_status, estimator,
                                acting_command == nullptr ? nullptr : &acting_command->tau,
                                !planned.reference().stepping, dt);
  state = estimator.state();
  if (wrong_sensor != Status::kOk) return wrong_sensor;
  if (estimator_status != Status::kOk) return estimator_status;
  time_since_estimate = 0.0;
  torque_command.observe_joints(state, dt);
  if (gain_ramp.moving()) apply_gains(gain_ramp.step(dt));
  const Dynamics& dynamics = estimator.dynamics();
  if (dynamics.R_world_base()(2, 2) < std::cos(controller.gains().fall_tilt)) {
    return Status::kFallen;
  }
  started = true;
  const Status plan_status = planned.plan(make_planner_input(
      estimator.state(), controller.gains(), dynamics, dt, predictor.horizon(clock.period()),
      robot.mass(), lost_leg, estimator.sole_sink()));
  if (!planned.has_reference()) return plan_status;
  estimator.set_ground_normal(planned.reference().ground_normal);
  estimator.set_stepping(planned.reference().stepping);
  torque_command.set_lost_leg(lost_leg);
  if (options.delay > 0.0 || planned.reference().stepping) {
    return predict_and_solve(plan_status, dt);
  }
  state.friction = usable_friction(dynamics, state, dt);
  return solve(dynamics, state, plan_status);
}

Status Controller::Impl::predict_and_solve(Status plan_status, double dt) noexcept {
  RobotState& predicted_state = predictor.predict(state, clock.period());
  predicted_dynamics.set_joints(state);
  predicted_dynamics.update(predicted_state.q, predicted_state.v,
                            planned.reference().ground_normal);
  predicted_state.friction = state.friction =
      usable_friction(predicted_dynamics, predicted_state, dt);
  return solve(predicted_dynamics, predicted_state, plan_status);
}

Eigen::Vector4d Controller::Impl::usable_friction(const Dynamics& dynamics,
                                                  const RobotState& used_state,
                                                  double dt) noexcept {
  const double learnt_share = estimator.ground_friction() / robot.config().friction;
  return friction.update(dynamics, used_state, planned.reference(), robot.mass(), learnt_share, dt);
}

// Hold the feet that had no load in the last solution. Without one, no load is known.
void Controller::Impl::hold_unloaded_feet(const Dynamics& dynamics,
                                          const RobotState& used_state) noexcept {
  const FeetMatrix& forces = controller.solution().forces;
  if (forces.isZero(kNoForce)) return;
  const Reference& reference = planned.reference();
  const Eigen::Vector4d loads =
      forces.transpose() * reference.ground_normal / (robot.mass() * kGravity);
  planned.add_to_feet(
      unloaded_feet_hold(controller.gains(), dynamics, used_state, reference, loads));
}

// Solve the QP, and again from a cold start if the first solve fails. Limit the power of the
// torques. Without a reference for this tick, there is no QP to solve.
Status Controller::Impl::solve(const Dynamics& dynamics, const RobotState& used_state,
                               Status plan_status) noexcept {
  if (plan_status != Status::kOk) {
    compute_fallback(dynamics, used_state);
    return plan_status;
  }
  hold_unloaded_feet(dynamics, used_state);
  const Solution& solution = controller.solve(dynamics, used_state, planned.reference());
  fallback_level = FallbackLevel::kSolved;
  if (!is_usable(solution.status)) {
    controller.solve_cold(dynamics);  // the reference `solution` now has the new result
    fallback_level = FallbackLevel::kColdSolve;
  }
  if (is_usable(solution.status)) {
    fallback_chain.remember(controller.gains(), dynamics, used_state, planned.reference(),
                            solution.forces);
    return torque_command.set_torques(solution, dynamics, used_state, planned.reference(),
                                      controller.gains());
  }
  compute_fallback(dynamics, used_state);
  return solution.status;
}

// Compute torques with the fallback chain, without the QP, and limit their power like that of a
// solution.
void Controller::Impl::compute_fallback(const Dynamics& dynamics,
                                        const RobotState& used_state) noexcept {
  const Gains& gains = controller.gains();
  fallback_level =
      fallback_chain.compute_fallback(gains, dynamics, used_state, planned.reference());
  if (fallback_level == FallbackLevel::kHold) return;
  torque_command.set_torques(fallback_chain.torques(), fallback_chain.damping(), dynamics,
                             used_state, planned.reference(), gains);
}

}  // namespace surefoot
