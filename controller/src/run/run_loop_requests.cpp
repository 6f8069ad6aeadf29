// SPDX-License-Identifier: BSD-3-Clause
// Requests to the loop, from other threads and from the remote's sticks.
#include <cmath>

#include "run/run_loop.hpp"

namespace surefoot {

namespace {

bool is_finite(const WalkVelocity& v) {
  return std::isfinite(v.vx) && std::isfinite(v.vy) && std::isfinite(v.yaw_rate);
}
bool is_finite(const BodyReference& r) {
  return std::isfinite(r.x + r.y + r.height + r.roll + r.pitch + r.yaw);
}

Gait next_gait(Gait gait) {
  switch (gait) {
    case Gait::kAuto:
      return Gait::kTrot;
    case Gait::kTrot:
      return Gait::kWalk;
    case Gait::kWalk:
      break;
  }
  return Gait::kAuto;
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
  WalkVelocity requested;
  if (velocity_mailbox_.take(requested) && is_finite(requested)) {
    requested_velocity_ = requested;
    velocity_time_ = snapshot_.time;
  }
  if (gait_mailbox_.take(gait_)) supervisor_.set_gait(gait_);
  BodyReference requested_pose;
  if (!reference_mailbox_.take(requested_pose)) return;
  supervisor_.set_body_reference(requested_pose);
  // The supervisor rejects a pose that is not finite. requested_pose_ keeps the last finite pose,
  // because apply_remote() adds the offsets of the sticks to it.
  if (is_finite(requested_pose)) requested_pose_ = requested_pose;
}

// The sticks move the body of a standing robot, and give the velocity of a walking one.
void RunLoop::apply_remote(const WirelessRemote& remote) noexcept {
  handle_start_button(remote.pressed(Button::kStart));
  handle_select_button(remote.pressed(Button::kSelect));
  const bool walks = supervisor_.mode() == Mode::kWalk;
  apply_velocity(walks ? remote_velocity(remote, stick_speeds_) : WalkVelocity());
  if (!options_.remote) return;
  const BodyReference sticks = walks ? BodyReference() : remote_reference(remote);
  supervisor_.set_body_reference(
      {requested_pose_.x + sticks.x, requested_pose_.y + sticks.y,
       requested_pose_.height + sticks.height, requested_pose_.roll + sticks.roll,
       requested_pose_.pitch + sticks.pitch, requested_pose_.yaw + sticks.yaw});
}

// START begins and ends a walk.
void RunLoop::handle_start_button(bool pressed) noexcept {
  if (pressed && !start_pressed_) {
    const bool walks = supervisor_.mode() == Mode::kWalk;
    snapshot_.start_answer = supervisor_.request(walks ? Mode::kStand : Mode::kWalk);
    ++snapshot_.start_presses;
    walk_by_remote_ = !walks && snapshot_.start_answer == RequestStatus::kAccepted;
  }
  start_pressed_ = pressed;
}

// SELECT chooses the next gait.
void RunLoop::handle_select_button(bool pressed) noexcept {
  if (pressed && !select_pressed_) {
    gait_ = next_gait(gait_);
    supervisor_.set_gait(gait_);
  }
  select_pressed_ = pressed;
}

// Pass the sum of set_velocity() and the sticks to the supervisor. If neither a program nor the
// remote gives a velocity, nothing is passed, so the velocity expires and the walk ends.
void RunLoop::apply_velocity(const WalkVelocity& sticks) noexcept {
  const bool is_current = snapshot_.time - velocity_time_ < options_.velocity_timeout;
  const bool sticks_moved = sticks.vx != 0.0 || sticks.vy != 0.0 || sticks.yaw_rate != 0.0;
  const bool had_velocity = has_velocity_;
  has_velocity_ = is_current || sticks_moved || walk_by_remote_;
  if (had_velocity && !has_velocity_)
    supervisor_.set_velocity({});  // it has timed out here already
  if (!has_velocity_) return;
  velocity_ = is_current ? requested_velocity_ : WalkVelocity();
  velocity_.vx += sticks.vx;
  velocity_.vy += sticks.vy;
  velocity_.yaw_rate += sticks.yaw_rate;
  supervisor_.set_velocity(velocity_);
}

}  // namespace surefoot
