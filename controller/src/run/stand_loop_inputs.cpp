// SPDX-License-Identifier: BSD-3-Clause
// What others ask of a loop, from other threads and by the sticks.
#include <cmath>

#include "run/remote_reference.hpp"
#include "run/stand_loop.hpp"

namespace surefoot {

namespace {

bool is_finite(const BodyReference& r) {
  return std::isfinite(r.x + r.y + r.height + r.roll + r.pitch + r.yaw);
}

}  // namespace

void StandLoop::rearm() noexcept {
  const RequestStatus got = supervisor_.arm();
  refused_ += got == RequestStatus::kNoState || got == RequestStatus::kNotReady;
}

void StandLoop::damp() noexcept {
  damp_.store(true);
  supervisor_.stop();
}

void StandLoop::set_gains(const Gains& gains) {
  gains.validate();
  gains_letter_.put(gains);
}

void StandLoop::obey_letters() noexcept {
  if (gains_letter_.take(gains_)) {
    supervisor_.set_gains(gains_);  // valid: see set_gains()
    damping_ = damping_low_cmd(gains_.damping_kd);
  }
  BodyReference asked;
  if (!reference_letter_.take(asked)) return;
  supervisor_.set_body_reference(asked);  // which refuses what is not finite ...
  if (is_finite(asked)) asked_ = asked;   // ... and would what the sticks add to it
}

void StandLoop::obey_sticks() noexcept {
  const WirelessRemote remote = decode_wireless_remote(link_.state().wirelessRemote);
  const BodyReference sticks = remote_reference(remote);
  supervisor_.set_body_reference({asked_.x + sticks.x, asked_.y + sticks.y,
                                  asked_.height + sticks.height, asked_.roll + sticks.roll,
                                  asked_.pitch + sticks.pitch, asked_.yaw + sticks.yaw});
}

}  // namespace surefoot
