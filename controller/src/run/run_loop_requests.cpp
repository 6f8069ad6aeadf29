// SPDX-License-Identifier: BSD-3-Clause
// Requests to the loop, from other threads and from the remote's sticks.
#include <cmath>

#include "run/remote_reference.hpp"
#include "run/run_loop.hpp"

namespace surefoot {

namespace {

bool is_finite(const BodyReference& r) {
  return std::isfinite(r.x + r.y + r.height + r.roll + r.pitch + r.yaw);
}

}  // namespace

void RunLoop::rearm() noexcept {
  const RequestStatus status = supervisor_.arm();
  refused_rearms_ += status == RequestStatus::kNoState || status == RequestStatus::kNotReady;
}

void RunLoop::damp() noexcept {
  damp_requested_.store(true);
  supervisor_.stop();
}

void RunLoop::set_gains(const Gains& gains) {
  gains.validate();
  gains_mailbox_.put(gains);
}

void RunLoop::apply_requests() noexcept {
  if (gains_mailbox_.take(gains_)) {
    supervisor_.set_gains(gains_);  // validated in set_gains()
    damping_ = damping_low_cmd(gains_.damping_kd);
  }
  BodyReference requested_pose;
  if (!reference_mailbox_.take(requested_pose)) return;
  supervisor_.set_body_reference(requested_pose);
  // The supervisor rejects a pose that is not finite. requested_pose_ keeps the last finite pose,
  // because apply_remote_sticks() adds the offsets of the sticks to it.
  if (is_finite(requested_pose)) requested_pose_ = requested_pose;
}

void RunLoop::apply_remote_sticks() noexcept {
  const WirelessRemote remote = decode_wireless_remote(link_.state().wirelessRemote);
  const BodyReference sticks = remote_reference(remote);
  supervisor_.set_body_reference(
      {requested_pose_.x + sticks.x, requested_pose_.y + sticks.y,
       requested_pose_.height + sticks.height, requested_pose_.roll + sticks.roll,
       requested_pose_.pitch + sticks.pitch, requested_pose_.yaw + sticks.yaw});
}

}  // namespace surefoot
