// SPDX-License-Identifier: BSD-3-Clause
// Phase, reasons, log and snapshot of the loop.
#include <algorithm>

#include "run/robot_snapshot.hpp"
#include "run/run_loop.hpp"

namespace surefoot {

// Add the tick to the log, until log_tail [s] after the last tick in a mode other than passive and
// damping. The log has a fixed size: if damping were logged for longer, it would overwrite the
// ticks that led to damping. So log_tail is at most half of the log.
void RunLoop::log(const LowCmd& command, bool has_new_state) noexcept {
  const Mode mode = supervisor_.mode();
  const double log_tail = std::min(5.0, 0.5 * options_.log_time);  // [s] 5 s: chosen
  if (mode != Mode::kPassive && mode != Mode::kDamping) last_driven_time_ = snapshot_.time;
  if (!link_->has_state() ||
      (last_driven_time_ >= 0.0 && snapshot_.time - last_driven_time_ > log_tail))
    return;
  log_.add({snapshot_.time, has_new_state, mode, supervisor_.damping_fault(), velocity_,
            has_new_state && has_velocity_, gait_, link_->state(), command});
}

// Update the phase, its reason and the counts after a tick.
void RunLoop::update_phase() noexcept {
  const Mode previous_mode = snapshot_.mode;
  snapshot_.mode = supervisor_.mode();
  const RunPhase phase = this->phase();
  update_stood_as_requested(previous_mode);
  if (phase == RunPhase::kDamping && snapshot_.phase != RunPhase::kDamping) {
    snapshot_.reason = damping_reason();
    snapshot_.power_at_damping = supervisor_.measured_power();
    ++snapshot_.dampings;
  }
  snapshot_.rearms += previous_mode == Mode::kDamping && snapshot_.mode != Mode::kDamping;
  if (snapshot_.mode == Mode::kStand && previous_mode == Mode::kWalk) {
    requested_pose_.x = requested_pose_.y = requested_pose_.yaw =
        0.0;  // the stand has a new origin
  } else if (snapshot_.mode == Mode::kStand && previous_mode != Mode::kStand) {
    requested_pose_ = {};
  }
  const bool may_begin = snapshot_.mode == Mode::kStand && previous_mode == Mode::kStand;
  if (snapshot_.mode != Mode::kWalk && !may_begin) walk_by_remote_ = false;
  snapshot_.stood = snapshot_.stood || snapshot_.mode == Mode::kStand;
  const bool duration_started = snapshot_.stood || options_.start == Start::kStanding;
  if (duration_started && duration_start_ < 0.0) duration_start_ = snapshot_.time;
  phase_changed_ = phase_changed_ || phase != snapshot_.phase;
  snapshot_.phase = phase;
}

// Update stood_as_requested_ when the mode changes. A change from kPassive to kDamping, while the
// robot lies, leaves stood_as_requested_ unchanged.
void RunLoop::update_stood_as_requested(Mode previous_mode) noexcept {
  if (snapshot_.mode == previous_mode) return;
  const bool damped_while_driven =
      snapshot_.mode == Mode::kDamping && previous_mode != Mode::kPassive;
  const bool sat_down_by_fault =
      snapshot_.mode == Mode::kSit &&
      supervisor_.faults().first_active(FaultReaction::kSit) != FaultId::kNone;
  if (damped_while_driven || sat_down_by_fault || snapshot_.mode == Mode::kRise)
    stood_as_requested_ = false;
  // A robot that damped and was armed again may lie.
  if (snapshot_.mode == Mode::kStand) stood_as_requested_ = !lies();
}

RunPhase RunLoop::phase() const noexcept {
  if (robot_silent_) return RunPhase::kDamping;
  switch (snapshot_.mode) {
    case Mode::kPassive:
      return RunPhase::kPassive;
    case Mode::kRise:
      return RunPhase::kRising;
    case Mode::kStand:
      return RunPhase::kStanding;
    case Mode::kWalk:
      return RunPhase::kWalking;
    case Mode::kSit:
      return RunPhase::kSitting;
    case Mode::kDamping:
      return RunPhase::kDamping;
  }
  return RunPhase::kDamping;
}

RunReason RunLoop::damping_reason() const noexcept {
  if (robot_silent_) return RunReason::kStale;
  switch (supervisor_.damping_fault()) {
    case FaultId::kLink:
      return link_loss_reason_;
    case FaultId::kStop:
      return RunReason::kRequested;
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

const RunSnapshot& RunLoop::snapshot() noexcept {
  snapshot_.link = link_->counts();
  snapshot_.last_reject = link_->last_reject();
  snapshot_.state_age = link_->state_age();
  snapshot_.damping_fault = supervisor_.damping_fault();
  snapshot_.arming = supervisor_.arming();
  snapshot_.faults = supervisor_.faults();
  snapshot_.armed = supervisor_.armed();
  snapshot_.rise_failed = supervisor_.rise_failed();
  snapshot_.rise_progress = supervisor_.rise_progress();
  snapshot_.rise_stage = supervisor_.rise_stage();
  snapshot_.stopping = supervisor_.stopping();
  snapshot_.refused_rearms = refused_rearms_.load();
  write_robot_snapshot(supervisor_.controller(), link_->state(), tau_max_, snapshot_);
  snapshot_.gait = gait_;
  return snapshot_;
}

bool RunLoop::take_phase_change() noexcept {
  const bool changed = phase_changed_;
  phase_changed_ = false;
  return changed;
}

}  // namespace surefoot
