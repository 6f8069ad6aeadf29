// SPDX-License-Identifier: BSD-3-Clause
// What leaves: of the springs, the program or the motors' damping, and of two of them in a fade.
#include "safety/torque_command.hpp"
#include "supervisor/common/motor_measurements.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {

constexpr double kRateLimitedTime = 0.008;  // [s] that torques lag before it is told: pushes are
                                            // believed over 6 ms, and may hold torques back as long

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
  // One that has not solved once since it was begun bridges nothing, and latches nothing.
  const bool program = fade.uses(TorqueSource::kController);
  const bool idle =
      unsolved.update(program && stand.fallback_level() == FallbackLevel::kDamping, dt, kHoldTime);
  if (idle || (program && stand.status() == Status::kDamping)) {
    const FaultId why = stand.fault() == Status::kFallen ? FaultId::kTilt : FaultId::kController;
    log.set(why, true);
    latch(why);
    return command_hold.accept(damping_low_cmd(damping_kd));
  }
  // Springs of a leg that slips off what it leant on change as fast as it does, and a blow takes a
  // tick or two to answer: that is no fault.
  const bool limited =
      rate_limiter.limit(demand.tau, demand.kd, measured_velocities(state), clock.period());
  log.set(FaultId::kTorqueRate,
          rate_limited.update(limited && program, clock.period(), kRateLimitedTime));
  return command_hold.accept(torque_low_cmd(demand.tau, demand.kd));
}

}  // namespace surefoot
