// SPDX-License-Identifier: BSD-3-Clause
#include "run/stand_loop.hpp"

#include <algorithm>

#include "run/remote_reference.hpp"
#include "run/run_view.hpp"

namespace surefoot {

namespace {

constexpr std::uint64_t kConvinced = 10;  // datagrams of another generation

}  // namespace

StandLoop::StandLoop(const Robot& robot, const Gains& gains, const StandOptions& stand,
                     const UdpLinkOptions& link, const RunOptions& options)
    : options_((options.validate(), options)),
      controller_(robot, gains, stand),
      safety_(robot),
      link_(link),
      tau_max_(robot.config().tau_max),
      damping_(damping_low_cmd(gains.damping_kd)) {}

void StandLoop::tick(double time, double elapsed) noexcept {
  now_.time = time;
  obey_letters();
  const bool newer = link_.receive();
  if (stop_.load()) end(RunReason::kAsked);
  const bool damped = damp_.exchange(false);
  const bool rearmed = rearm_.exchange(false) && !damped;
  if (damped) latch(RunReason::kAsked);
  switch (now_.phase) {
    case RunPhase::kWaiting:
      wait_for_robot();
      break;
    case RunPhase::kStanding:
      stand(newer, elapsed);
      break;
    case RunPhase::kDamping:
      stay_damped(newer, rearmed);
      break;
    case RunPhase::kEnded:
      send_damping();
      break;
  }
  if (now_.ticks > 0 && time - begun_ > options_.duration) end(RunReason::kAsked);
}

void StandLoop::wait_for_robot() noexcept {
  send_damping();
  if (link_.known()) {
    begun_ = now_.time;
    begin();
  } else if (link_.counts().wrong_generation >= kConvinced) {
    end(RunReason::kWrongGeneration);
  } else if (now_.time > options_.patience) {
    end(RunReason::kNoState);
  }
}

void StandLoop::begin() noexcept {
  controller_.reset();
  safety_.reset();
  asked_ = {};
  last_ = damping_;
  silence_.heard(now_.time, link_.state().tick);
  restarts_ = link_.counts().restarts;
  now_.phase = RunPhase::kStanding;
}

void StandLoop::stand(bool newer, double elapsed) noexcept {
  ++now_.ticks;
  if (elapsed > kAwayTime) {
    now_.gap = elapsed;
    latch(RunReason::kAway);
  }
  if (link_.counts().restarts != restarts_) latch(RunReason::kRestart);
  const double age = link_.age();
  if (newer && age < kHoldTime) {
    control(link_.state());
  } else {
    bridge(age, elapsed);
  }
  link_.send(now_.phase == RunPhase::kStanding ? last_ : damping_);
}

void StandLoop::control(const LowState& state) noexcept {
  silence_.heard(now_.time, state.tick);
  if (options_.remote) obey_remote();
  last_ = controller_.update(state);
  now_.status = controller_.status();
  now_.fault = controller_.fault();
  now_.usable += is_usable(now_.status);
  now_.saturated += now_.status == Status::kSaturated;
  if (options_.power_level > 0) {
    const bool tripped = safety_.power_protect(last_, state, options_.power_level) < 0;
    now_.power = safety_.power();
    now_.greatest_power = std::max(now_.greatest_power, now_.power);
    if (tripped) latch(RunReason::kPowerProtect);
  }
  if (now_.status == Status::kDamping) latch(RunReason::kController);
}

// No new report: the command before, then damping, then that for good.
void StandLoop::bridge(double age, double elapsed) noexcept {
  ++now_.bridged;
  if (age > kHoldTime) last_ = damping_;
  if (silence_.is_stale(age, elapsed, 1.0 / options_.rate)) {
    now_.gap = age;
    latch(RunReason::kStale);
  }
}

void StandLoop::stay_damped(bool newer, bool rearmed) noexcept {
  send_damping();
  const bool fresh = link_.age() < kStaleTime;
  const bool same_robot = link_.counts().restarts == restarts_;
  if (newer && fresh && same_robot && now_.reason == RunReason::kStale &&
      silence_.stood_still(now_.time, link_.state().tick)) {
    ++now_.pauses;
    now_.phase = RunPhase::kStanding;
  } else if (rearmed && fresh) {
    ++now_.rearms;
    begin();
  } else if (rearmed) {
    ++now_.refused_rearms;
  }
}

void StandLoop::set_gains(const Gains& gains) {
  gains.validate();
  gains_letter_.put(gains);
}

void StandLoop::obey_letters() noexcept {
  if (gains_letter_.take(gains_)) {
    controller_.set_gains(gains_);  // valid: see set_gains()
    damping_ = damping_low_cmd(gains_.damping_kd);
  }
  if (reference_letter_.take(asked_)) controller_.set_body_reference(asked_);
}

void StandLoop::obey_remote() noexcept {
  const WirelessRemote remote = decode_wireless_remote(link_.state().wirelessRemote);
  const BodyReference sticks = remote_reference(remote);
  controller_.set_body_reference({asked_.x + sticks.x, asked_.y + sticks.y,
                                  asked_.height + sticks.height, asked_.roll + sticks.roll,
                                  asked_.pitch + sticks.pitch, asked_.yaw + sticks.yaw});
  if (remote.pressed(kDampingButton)) latch(RunReason::kButton);
}

void StandLoop::latch(RunReason why) noexcept {
  if (now_.phase == RunPhase::kDamping && why == RunReason::kAsked) now_.reason = why;
  if (now_.phase != RunPhase::kStanding) return;
  now_.phase = RunPhase::kDamping;
  now_.reason = why;
  ++now_.dampings;
  news_ = true;
}

void StandLoop::end(RunReason why) noexcept {
  // What it ended for counts, unless it was damping for something before; and with no robot it has
  // controlled nothing, whoever asked for the end.
  if (now_.phase == RunPhase::kWaiting && why == RunReason::kAsked) why = RunReason::kNoState;
  if (now_.phase != RunPhase::kDamping) now_.reason = why;
  now_.phase = RunPhase::kEnded;
}

const RunSnapshot& StandLoop::describe() noexcept {
  now_.link = link_.counts();
  now_.reject = link_.last_reject();
  now_.age = link_.age();
  view_robot(controller_, link_.state(), tau_max_, now_);
  return now_;
}

bool StandLoop::has_news() noexcept {
  const bool news = news_;
  news_ = false;
  return news;
}

}  // namespace surefoot
