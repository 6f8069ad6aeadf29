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
  if (age > kStaleTime) now.seen = false;
  publish();
  const bool moving = active() || fade.moving();
  if (moving && age <= kHoldTime) return keeper.last();
  motors.interrupted();
  return keeper.accept(damping_low_cmd(damping_kd));
}

void Supervisor::Impl::lose() noexcept {
  if (now.armed) {
    log.set(FaultId::kLink, true);
    latch(FaultId::kLink);
  }
  requests.take();
  arming.distrust();
  // What was before says nothing of what comes.
  clock.reset();
  joints = {};
  encoders = {};
  pace = {};
  imu = {};
  repeated = {};
  now.seen = now.ready = fresh = false;
  publish();
}

void Supervisor::Impl::set_gains(const Gains& gains) {
  stand.set_gains(gains);
  damping_kd = gains.damping_kd;
}

}  // namespace surefoot
