// SPDX-License-Identifier: BSD-3-Clause
// Handles periods without a sample, and the loss of the link.
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
  // `age` is the age of the last sample. If that sample was unusable, command_hold.age() is the age
  // that the last good command had then, otherwise 0. So the sum is the present age of the last
  // good command.
  if (applies_torque() && known_age && age + command_hold.age() <= kHoldTime)
    return command_hold.last();
  motors.skip_command();
  rate_limiter.set_damping_only(damping_kd);  // the next torques then rise from zero
  return command_hold.damp(damping_kd);
}

// Drop pending requests and reject new ones, because no valid sample has arrived for a while.
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
  // Samples after the loss must not be compared with samples from before the loss.
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
  controller.set_gains(gains);
  damping_kd = gains.damping_kd;
  folding.set_wait(gains.fold_wait);
}

}  // namespace surefoot
