// SPDX-License-Identifier: BSD-3-Clause
// Commands from the joint impedance, the StandController or damping; during a fade from two of
// them.
#include "safety/torque_command.hpp"
#include "supervisor/common/motor_measurements.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {

// [s] of limited torques before it is a fault. Derived: one period more than the 6 ms over which
// the estimator accepts a push, when torques may be limited. Above: the 10 ms of fault_table().
constexpr double kRateLimitedTime = 0.008;

}  // namespace

MotorDemand Supervisor::Impl::demand_of(TorqueSource source, const LowState& state) noexcept {
  MotorDemand out;
  if (source == TorqueSource::kDamping) out.kd.setConstant(damping_kd);
  if (source == TorqueSource::kImpedance) {
    out.tau = impedance.torques(reference, is_raising_body() ? motion.load() : 0.0);
    out.kd.setConstant(impedance.damping());
  }
  if (source != TorqueSource::kController) return out;
  const LowCmd& command = stand.update(state);
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
    const MotorDemand before = demand_of(fade.from(), state);
    const double w = fade.weight();
    demand.tau = (1.0 - w) * before.tau + w * demand.tau;
    demand.kd = (1.0 - w) * before.kd + w * demand.kd;
  }
  // A StandController without a solution since its reset has no command to hold and never latches
  // its own damping: time it here.
  const bool uses_controller = fade.uses(TorqueSource::kController);
  const bool idle = unsolved.update(
      uses_controller && stand.fallback_level() == FallbackLevel::kDamping, dt, kHoldTime);
  if (idle || (uses_controller && stand.status() == Status::kDamping)) {
    const FaultId why = stand.fault() == Status::kFallen ? FaultId::kTilt : FaultId::kController;
    log.set(why, true);
    latch(why);
    return command_hold.accept(damping_low_cmd(damping_kd));
  }
  // Only the StandController's torques can be a fault, and only if limited for long. Impedance
  // torques of a slipping leg change as fast as the leg moves; an impact takes a tick or two.
  const bool limited =
      rate_limiter.limit(demand.tau, demand.kd, measured_velocities(state), clock.period());
  log.set(FaultId::kTorqueRate,
          rate_limited.update(limited && uses_controller, clock.period(), kRateLimitedTime));
  return command_hold.accept(torque_low_cmd(demand.tau, demand.kd));
}

}  // namespace surefoot
