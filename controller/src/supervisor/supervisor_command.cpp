// SPDX-License-Identifier: BSD-3-Clause
// Computes the command, from joint impedance, controller or damping. During a fade the command
// is the weighted mean of two of these sources.
#include "safety/torque_command.hpp"
#include "supervisor/common/motor_measurements.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {

// [s] Time for which the torques must be rate-limited before the fault torque_rate is reported.
// Derived: at the start of a push the estimator responds within 6 ms, and torques may be limited
// for so long; plus one period. Shorter than the 10 ms of fault_table().
constexpr double kRateLimitedTime = 0.008;
// [s] The same if the torques began to be limited while feet stepped: loads move from one pair of
// feet to the other, and the torques are limited for up to 40 ms (go1) and 100 ms (b1) in each
// step, also in the last one, after which the robot stands or sits down.
constexpr double kSteppingRateLimitedTime = 0.3;

}  // namespace

MotorDemand Supervisor::Impl::demand_of(TorqueSource source, const LowState& state) noexcept {
  MotorDemand out;
  if (source == TorqueSource::kDamping) out.kd.setConstant(damping_kd);
  if (source == TorqueSource::kImpedance) {
    out.tau = impedance.torques(reference, is_raising_body() ? motion.load() : 0.0);
    out.kd.setConstant(impedance.damping());
  }
  if (source != TorqueSource::kController) return out;
  const LowCmd& command = controller.update(state);
  for (int i = 0; i < kMotors; ++i) {
    out.tau[i] = command.motorCmd[i].tau;
    out.kd[i] = command.motorCmd[i].Kd;
  }
  return out;
}

const LowCmd& Supervisor::Impl::command(const LowState& state, double dt) noexcept {
  fade.advance(dt);
  MotorDemand demand = demand_of(fade.to(), state);
  if (fade.active()) {
    const MotorDemand from_demand = demand_of(fade.from(), state);
    const double w = fade.weight();
    demand.tau = (1.0 - w) * from_demand.tau + w * demand.tau;
    demand.kd = (1.0 - w) * from_demand.kd + w * demand.kd;
  }
  // A controller that has had no solution since its reset has no command to repeat, and never
  // latches damping by itself. So the time without a solution is measured here.
  const bool uses_controller = fade.uses(TorqueSource::kController);
  const bool controller_idle = unsolved.update(
      uses_controller && controller.fallback_level() == FallbackLevel::kDamping, dt, kHoldTime);
  if (controller_idle || (uses_controller && controller.status() == Status::kDamping)) {
    const FaultId why =
        controller.fault() == Status::kFallen ? FaultId::kTilt : FaultId::kController;
    log.set(why, true);
    latch(why);
    return command_hold.accept(damping_low_cmd(damping_kd));
  }
  // Rate-limited torques are a fault only if they come from the controller and stay limited
  // for kRateLimitedTime. Impedance torques of a slipping leg change as fast as the leg moves, and
  // an impact lasts for one or two ticks.
  const bool limited =
      rate_limiter.limit(demand.tau, demand.kd, measured_velocities(state), clock.period());
  const bool counts = limited && uses_controller;
  limited_by_step = counts && (limited_by_step || controller.reference().stepping);
  log.set(FaultId::kTorqueRate,
          rate_limited.update(counts, clock.period(),
                              limited_by_step ? kSteppingRateLimitedTime : kRateLimitedTime));
  return command_hold.accept(torque_low_cmd(demand.tau, demand.kd));
}

}  // namespace surefoot
