// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a supervised robot that is not heard.
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
  // Reports that were bad have not made the last command any younger.
  if (applies_torque() && known_age && age + command_hold.age() <= kHoldTime)
    return command_hold.last();
  motors.skip_command();
  rate_limiter.set_damping_only(damping_kd);  // torques come back from nothing
  return command_hold.damp(damping_kd);
}

// Nothing valid has come for a while: what was asked of another moment is void.
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
  // What was before says nothing of what comes.
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
