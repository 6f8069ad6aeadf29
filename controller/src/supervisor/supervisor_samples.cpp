// SPDX-License-Identifier: BSD-3-Clause
// Checks each sample, and finds the fault that makes it unusable.
#include <cmath>
#include <utility>

#include "low_level/low_state_check.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

bool Supervisor::Impl::read_sample(const LowState& state, double step, double dt) noexcept {
  const FaultId before = sample_fault;
  sample_fault = step < 0.0 ? FaultId::kStaleTick : find_sample_fault(state, step);
  if (sample_fault != before) log.set(before, false);
  if (sample_fault != FaultId::kNone) log.set(sample_fault, true);
  const FaultId sit_fault = log.report().first_active(FaultReaction::kSit);
  const FaultId blocking_fault = log.report().has(FaultId::kButton) ? FaultId::kButton : sit_fault;
  arming.set_blocking_fault(sample_fault != FaultId::kNone ? sample_fault : blocking_fault);
  // After a long gap or a restart, the samples may come from another robot. So a lying robot must
  // be armed again.
  const double since_last_sample = 1e-3 * static_cast<std::int32_t>(state.tick - last_tick);
  if (state_received && !active() && !context.checks_waived && !arming.has_link_counts() &&
      std::abs(since_last_sample) > kStaleTime) {
    context.armed = false;
    arming.clear_ready();
    fade.switch_to(TorqueSource::kDamping);  // end any fade that began before the gap
  }
  last_tick = state.tick;
  if (step < 0.0) {
    arming.count_missed();
    // While the robot is not active, no motion depends on the clock. So the clock starts again, and
    // accepts the new tick of a robot that has restarted.
    if (!active()) clock.reset();
  } else {
    arming.update(state, step);
    if (sample_fault != FaultId::kNone) arming.clear_ready();
  }
  if (sample_fault == FaultId::kNone) {
    if (has_unit_quaternion(state.imu)) impedance.read(state);
    context.state_valid = state_received = true;
  }
  bad_time = sample_fault == FaultId::kNone ? 0.0 : bad_time + dt;
  if (bad_time > kStaleTime) {
    requests.take();
    // With arming checks, `ready` is already false and blocks requests. Without arming checks only
    // state_valid can block them.
    if (context.checks_waived) context.state_valid = false;
  }
  // A robot that sits down on three legs must be armed again before it can rise.
  const bool without_leg = active() && controller.lost_leg() >= 0;
  context.must_sit = blocking_fault != FaultId::kNone || without_leg || arming.has_conflict();
  context.must_stand = without_leg || log.report().stops_walking() != FaultId::kNone;
  context.ready = arming.report().ready && !context.must_sit;
  return sample_fault == FaultId::kNone;
}

// Return the fault that makes a sample unusable, or kNone.
FaultId Supervisor::Impl::find_sample_fault(const LowState& state, double step) noexcept {
  repeated.update(state, step);
  unchecked_time += step;
  const Status status = check_low_state(state, robot.config());
  if (status == Status::kNonFinite) return FaultId::kStateNotFinite;
  if (status != Status::kOk) return FaultId::kStateImplausible;
  // The power protection runs on every plausible sample, also on samples that are rejected below:
  // in an impact the IMU may jump, and the motors take much power at the same time. power_protect()
  // does not read the command.
  const bool protect = applies_torque() && options.power_level > 0;
  if (!protect) safety.reset();
  log.set(FaultId::kPower,
          protect && safety.power_protect(LowCmd{}, state, options.power_level) < 0);
  const double elapsed = std::exchange(unchecked_time, 0.0);
  const bool joints_fit = joints.update(state, elapsed, controller.lost_leg());
  imu.update(state.imu, elapsed, !repeated.repeats(),
             is_stepping()  ? ImuMotion::kSteps
             : is_on_feet() ? ImuMotion::kStands
                            : ImuMotion::kTurns);
  if (!joints_fit) return FaultId::kJointJump;
  // A robot on its feet uses the attitude of its estimator. So the IMU's attitude may be
  // implausible, but not its gyroscope.
  if (!imu.rates_plausible() || !(imu.attitude_plausible() || is_on_feet()))
    return FaultId::kAttitude;
  // After a gap longer than kRobotWatchdogTime the robot has damped by itself. If the caller uses
  // count_samples(), it detects gaps itself and calls report_link_lost().
  if (active() && !arming.has_link_counts() && clock.gap() > kRobotWatchdogTime)
    return FaultId::kStaleTick;
  // While the motors only damp, old values do no harm. Then only stopped sensors are a fault.
  const bool old = active() ? repeated.too_old() : repeated.stopped();
  return old ? FaultId::kFrozen : FaultId::kNone;
}

}  // namespace surefoot
