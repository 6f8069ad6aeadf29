// SPDX-License-Identifier: BSD-3-Clause
// What leaves: of the springs, the program or the motors' damping, and of two of them in a fade.
#include "safety/torque_command.hpp"
#include "supervisor/motor_values.hpp"
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

namespace {

constexpr double kHeldBack = 0.008;  // [s] that torques lag before it is told: pushes are
                                     // believed over 6 ms, and may hold torques back as long

}  // namespace

Drive Supervisor::Impl::drive(Source source, const LowState& state) noexcept {
  Drive out;
  if (source == Source::kDamping) out.kd.setConstant(damping_kd);
  if (source == Source::kSprings) {
    out.tau = springs.torques(reference, upward() ? motion.load() : 0.0);
    out.kd.setConstant(springs.damping());
  }
  if (source != Source::kProgram) return out;
  const LowCmd& command = stand.update(state);
  for (int i = 0; i < kMotors; ++i) {
    out.tau[i] = command.motorCmd[i].tau;
    out.kd[i] = command.motorCmd[i].Kd;
  }
  return out;
}

const LowCmd& Supervisor::Impl::command(const LowState& state, double dt) noexcept {
  fade.advance(dt);
  Drive drive = this->drive(fade.to(), state);
  if (fade.moving()) {
    const Drive before = this->drive(fade.from(), state);
    const double w = fade.weight();
    drive.tau = (1.0 - w) * before.tau + w * drive.tau;
    drive.kd = (1.0 - w) * before.kd + w * drive.kd;
  }
  // One that has not solved once since it was begun bridges nothing, and latches nothing.
  const bool program = fade.needs(Source::kProgram);
  const bool idle = unsolved.update(program && stand.rung() == Rung::kDamping, dt, kHoldTime);
  if (idle || (program && stand.status() == Status::kDamping)) {
    const FaultId why = stand.fault() == Status::kFallen ? FaultId::kTilt : FaultId::kController;
    log.set(why, true);
    latch(why);
    return keeper.accept(damping_low_cmd(damping_kd));
  }
  // Springs of a leg that slips off what it leant on change as fast as it does, and a blow takes a
  // tick or two to answer: that is no fault.
  const bool limited = rate.limit(drive.tau, drive.kd, measured_speeds(state), clock.period());
  log.set(FaultId::kTorqueRate, held_back.update(limited && program, clock.period(), kHeldBack));
  return keeper.accept(torque_low_cmd(drive.tau, drive.kd));
}

}  // namespace surefoot
