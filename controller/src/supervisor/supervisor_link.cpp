// SPDX-License-Identifier: BSD-3-Clause
// Periods without a sample, and loss of the link.
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

const LowCmd& Supervisor::Impl::update_without_state(double age) noexcept {
  if (requests.take_stop()) {
    log.set(FaultId::kStop, true);
    latch(FaultId::kStop);
  }
  fresh = false;
  const bool known_age = age >= 0.0;  // neither negative nor NaN
  if (!known_age || age > kStaleTime) invalidate_state();
  publish();
  // The age of the last command includes the time of unusable samples before this gap.
  if (applies_torque() && known_age && age + command_hold.age() <= kHoldTime)
    return command_hold.last();
  motors.skip_command();
  rate_limiter.set_damping_only(damping_kd);  // later torques start from zero
  return command_hold.damp(damping_kd);
}

// No valid sample has come for a while: pending requests no longer apply.
void Supervisor::Impl::invalidate_state() noexcept {
  context.state_valid = false;
  requests.take();
}

void Supervisor::Impl::report_link_lost() noexcept {
  if (context.armed) {
    log.set(FaultId::kLink, true);
    latch(FaultId::kLink);
  }
  invalidate_state();
  arming.clear_ready();
  // Later samples must not be compared with samples from before the loss.
  clock.reset();
  joints = {};
  encoders = {};
  clock_monitor = {};
  imu = {};
  repeated = {};
  state_received = context.ready = fresh = false;
  publish();
}

void Supervisor::Impl::set_gains(const Gains& gains) {
  stand.set_gains(gains);
  damping_kd = gains.damping_kd;
  folding.set_wait(gains.fold_wait);
}

}  // namespace surefoot
