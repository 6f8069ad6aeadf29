// SPDX-License-Identifier: BSD-3-Clause
// What a loop says of itself.
#include <algorithm>

#include "run/run_view.hpp"
#include "run/stand_loop.hpp"

namespace surefoot {

// A robot that brakes until somebody comes must not push out of the log why it does.
void StandLoop::log(const LowCmd& command, bool heard) noexcept {
  const Mode mode = supervisor_.mode();
  const double aftermath = std::min(5.0, 0.5 * options_.log_time);  // [s]
  if (mode != Mode::kPassive && mode != Mode::kDamping) driven_ = now_.time;
  if (!link_.known() || (driven_ >= 0.0 && now_.time - driven_ > aftermath)) return;
  log_.add({now_.time, heard, mode, supervisor_.reason(), link_.state(), command});
}

// What has become of it in this tick?
void StandLoop::watch() noexcept {
  const Mode before = now_.mode;
  now_.mode = supervisor_.mode();
  const RunPhase phase = this->phase();
  judge_order(before);
  if (phase == RunPhase::kDamping && now_.phase != RunPhase::kDamping) {
    now_.reason = why_damped();
    now_.damped_power = supervisor_.power();
    ++now_.dampings;
  }
  now_.rearms += before == Mode::kDamping && now_.mode != Mode::kDamping;
  if (now_.mode == Mode::kStand && before != Mode::kStand) asked_ = {};
  now_.stood = now_.stood || now_.mode == Mode::kStand;
  const bool begun = now_.stood || options_.start == Start::kStanding;
  if (begun && counts_from_ < 0.0) counts_from_ = now_.time;
  news_ = news_ || phase != now_.phase;
  now_.phase = phase;
}

// Who lies already may well be damped.
void StandLoop::judge_order(Mode before) noexcept {
  if (now_.mode == before) return;
  const bool let_go_of = now_.mode == Mode::kDamping && before != Mode::kPassive;
  const bool by_fault =
      now_.mode == Mode::kSit && supervisor_.faults().first(FaultReaction::kSit) != FaultId::kNone;
  if (let_go_of || by_fault || now_.mode == Mode::kRise) in_order_ = false;
  if (now_.mode == Mode::kStand) in_order_ = true;
}

RunPhase StandLoop::phase() const noexcept {
  if (silent_) return RunPhase::kDamping;
  switch (now_.mode) {
    case Mode::kPassive:
      return RunPhase::kPassive;
    case Mode::kRise:
      return RunPhase::kRising;
    case Mode::kStand:
      return RunPhase::kStanding;
    case Mode::kSit:
      return RunPhase::kSitting;
    case Mode::kDamping:
      return RunPhase::kDamping;
  }
  return RunPhase::kDamping;
}

RunReason StandLoop::why_damped() const noexcept {
  if (silent_) return RunReason::kStale;
  switch (supervisor_.reason()) {
    case FaultId::kLink:
      return lost_;
    case FaultId::kStop:
      return RunReason::kAsked;
    case FaultId::kButton:
      return RunReason::kButton;
    case FaultId::kPower:
      return RunReason::kPowerProtect;
    case FaultId::kController:
      return RunReason::kController;
    default:
      return RunReason::kFault;
  }
}

const RunSnapshot& StandLoop::describe() noexcept {
  now_.link = link_.counts();
  now_.reject = link_.last_reject();
  now_.age = link_.age();
  now_.damping = supervisor_.reason();
  now_.arming = supervisor_.arming();
  now_.faults = supervisor_.faults();
  now_.armed = supervisor_.armed();
  now_.stuck = supervisor_.stuck();
  now_.way_up = supervisor_.height();
  now_.stage = supervisor_.stage();
  now_.refused_rearms = refused_.load();
  view_robot(supervisor_.stand(), link_.state(), tau_max_, now_);
  return now_;
}

bool StandLoop::has_news() noexcept {
  const bool news = news_;
  news_ = false;
  return news;
}

}  // namespace surefoot
