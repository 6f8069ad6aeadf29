// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a supervised robot that is not heard.
#include "supervisor/supervisor_impl.hpp"

namespace surefoot {

const LowCmd& Supervisor::Impl::bridge(double age) noexcept {
  if (requests.take_stop()) {
    log.set(FaultId::kStop, true);
    latch(FaultId::kStop);
  }
  fresh = false;
  const bool known_age = age >= 0.0;  // neither negative nor NaN
  if (!known_age || age > kStaleTime) forget();
  publish();
  // Reports that were bad have not made the last command any younger.
  if (drives() && known_age && age + keeper.age() <= kHoldTime) return keeper.last();
  motors.interrupted();
  rate.rest(damping_kd);  // torques come back from nothing
  return keeper.damp(damping_kd);
}

// Nothing valid has come for a while: what was asked of another moment is void.
void Supervisor::Impl::forget() noexcept {
  now.seen = false;
  requests.take();
}

void Supervisor::Impl::lose() noexcept {
  if (now.armed) {
    log.set(FaultId::kLink, true);
    latch(FaultId::kLink);
  }
  forget();
  arming.distrust();
  // What was before says nothing of what comes.
  clock.reset();
  joints = {};
  encoders = {};
  pace = {};
  imu = {};
  repeated = {};
  known = now.ready = fresh = false;
  publish();
}

void Supervisor::Impl::set_gains(const Gains& gains) {
  stand.set_gains(gains);
  damping_kd = gains.damping_kd;
  folding.set_wait(gains.fold_wait);
}

}  // namespace surefoot
