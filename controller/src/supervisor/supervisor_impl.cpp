// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/supervisor_impl.hpp"

#include <cmath>

#include "safety/torque_command.hpp"
#include "surefoot/wireless_remote.hpp"
#include "tick/controller_access.hpp"

namespace surefoot {

namespace {

// Limits of the power, as shares of the power at which the power protection trips. Chosen by hand,
// below 1. Measured with these values: at most 93 W at level 1 (100 W) in benchmarks/get_up.py; no
// trip in benchmarks/false_trips.py.
constexpr double kPlannedShare = 0.5;  // power of the holding torques in the rise plan
// Limit of JointImpedance. Lower than kControllerShare, because JointImpedance uses measured
// velocities, which are 5 ms old.
constexpr double kImpedanceShare = 0.8;
constexpr double kControllerShare = 0.9;  // limit of WalkController
constexpr Button kStopButton = Button::kB;

// Return the power [W] at which the power protection trips.
double protection_power(const SupervisorOptions& options) {
  options.validate();
  return Safety::kWattsPerLevel * std::max(options.power_level, 1);
}

// Return the options of the controller, with power_limit below the power at which the power
// protection trips.
ControllerOptions within_power(const SupervisorOptions& options) {
  ControllerOptions stand = options.stand;
  if (options.power_level > 0) {
    stand.power_limit = std::min(stand.power_limit, kControllerShare * protection_power(options));
  }
  return stand;
}

}  // namespace

Supervisor::Impl::Impl(const Robot& r, const Gains& gains, const SupervisorOptions& o)
    : robot(r),
      options(o),
      plan(plan_rise(r, kPlannedShare * protection_power(o))),
      arming(r, {o.arming_time, o.temperature_warning, o.joint_margin, plan.max_holding_share}),
      folding(plan, gains.fold_wait),
      weight_check(plan),
      press_check(plan),
      motion(plan),
      impedance(r, plan, kImpedanceShare * protection_power(o)),
      controller(r, gains, {within_power(o), o.velocity_timeout}),
      safety(r),
      motors(r, o.temperature_warning, o.temperature_stop, o.joint_margin),
      estimator_faults(o.payload_limit),
      rate_limiter(r.config().tau_max),
      damping_kd(gains.damping_kd) {
  // Arming checks and fault detectors judge the sensors of a supervised robot. A sensor that fails
  // while the robot stands has a reaction of its own there; the sensor check would always damp.
  ControllerAccess::end_sensor_check(controller);
  context.can_walk = controller.can_walk();
  context.checks_waived = o.start == Start::kStanding;
  publish();
}

// Do the five steps of a tick that the comment of Supervisor::Impl lists.
const LowCmd& Supervisor::Impl::tick(const LowState& state) noexcept {
  const double step = clock.advance(state.tick);
  const double dt = step > 0.0 ? std::min(step, TickClock::kMaxStep) : clock.period();
  const bool good = read_sample(state, step, dt);
  log.set(FaultId::kLink, false);
  log.set(FaultId::kStop, requests.take_stop());
  const bool pressed = decode_wireless_remote(state.wirelessRemote).pressed(kStopButton);
  log.set(FaultId::kButton, pressed && options.remote);
  if (good) judge(state, dt);
  react();
  if (good) {
    handle_request(requests.take());
    const bool waits = context.mode == Mode::kPassive && !context.armed;
    if (context.checks_waived && waits && !arming.has_conflict()) take_over();
    step_motion(state, dt);
    step_walk(dt);
  }
  const LowCmd* out = nullptr;
  if (!applies_torque()) {
    rate_limiter.set_damping_only(damping_kd);
    out = &command_hold.accept(damping_low_cmd(damping_kd));
  } else if (good) {
    out = &command(state, dt);
  } else {
    out = &command_hold.repeat_or_damp(dt, damping_kd);
    motors.skip_command();
    if (command_hold.latched() || clock.gap() > kRobotWatchdogTime) latch(sample_fault);
  }
  if (good) motors.record_command(*out, state);
  const bool uses_controller = good && fade.uses(TorqueSource::kController);
  fresh = good && (!uses_controller || is_fresh(controller.fallback_level()));
  const bool used_fallback = controller.fallback_level() != FallbackLevel::kSolved &&
                             controller.fallback_level() != FallbackLevel::kDamping;
  log.set(FaultId::kProgram, uses_controller && used_fallback);
  publish();
  return *out;
}

// Carry out a request. The request is checked again, because the mode may have changed since
// another thread posted the request.
void Supervisor::Impl::handle_request(int request) noexcept {
  if (request == Requests::kArm) {
    if (judge_arming(context) != RequestStatus::kAccepted) return;
    const bool take_over_now = context.checks_waived && context.mode == Mode::kDamping;
    context.mode = Mode::kPassive;
    context.armed = true;
    command_hold.reset();
    clock_monitor = {};  // otherwise ClockMonitor keeps its last verdict while the joints rest
    for (const FaultId cleared :
         {FaultId::kController, FaultId::kWiring, FaultId::kWrongRobot, FaultId::kLegLost}) {
      log.set(cleared, false);
    }
    latched_fault = FaultId::kNone;
    if (take_over_now) {
      take_over();
    } else {
      controller.reset();  // all four legs count again
    }
  } else if (request != Requests::kNoRequest) {
    const Mode mode = static_cast<Mode>(request);
    if (judge_request(context, mode) == RequestStatus::kAccepted) enter_mode(mode);
  }
}

// Take over a robot that already stands. Torques do not fade in, because the robot would sink
// during the fade.
void Supervisor::Impl::take_over() noexcept {
  controller.reset();
  motors.reset();
  context.mode = Mode::kStand;
  context.armed = true;
  stage = RiseStage::kUp;  // in any other stage sit() would only damp, as for a lying robot
  motion.start(1.0, impedance.q());
  rate_limiter.reset();
  fade.switch_to(TorqueSource::kController);
}

void Supervisor::Impl::latch(FaultId why) noexcept {
  requests.take();  // drop earlier requests
  if (context.mode == Mode::kDamping) return;
  context.mode = Mode::kDamping;
  context.armed = context.ready = context.stopping = false;
  arming.clear_ready();  // the checks must pass for the full arming_time again
  fade.switch_to(TorqueSource::kDamping);
  rate_limiter.set_damping_only(damping_kd);
  unsolved = rate_limited = {};
  limited_by_step = false;
  log.set(FaultId::kTorqueRate, false);
  // The rise has ended, and this fault must not block the next rise.
  log.set(FaultId::kHanging, false);
  latched_fault = why;
}

void Supervisor::Impl::publish() noexcept {
  context.fading = fade.active();
  requests.publish(context);
  arming_report.write(arming.report());
  faults.write(log.report());
  published_stage = stage;
  const bool raising = active() && is_raising_body();
  published_progress = raising ? motion.position() : 0.0;
}

}  // namespace surefoot
