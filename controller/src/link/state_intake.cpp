// SPDX-License-Identifier: BSD-3-Clause
#include "link/state_intake.hpp"

#include "common/command_times.hpp"

namespace surefoot {

bool StateIntake::accept(const LowState& incoming, double time, bool ticks_show_losses) noexcept {
  LinkCounts& counts = status.counts;
  ++counts.valid;
  const TickSequence::Arrival arrival = sequence_.classify(incoming.tick, time);
  if (ticks_show_losses) counts.lost = sequence_.lost();
  if (arrival == TickSequence::Arrival::kDuplicate) {
    ++counts.duplicate;
    return false;
  }
  if (arrival == TickSequence::Arrival::kReordered) {
    ++counts.reordered;
    return false;
  }
  if (arrival == TickSequence::Arrival::kRestarted) ++counts.restarts;
  if (status.has_state && time - status.arrival_time > kHoldTime) ++counts.late;
  status.has_state = true;
  status.arrival_time = time;
  status.state = incoming;
  return true;
}

void StateIntake::reject(const FrameReport& report) noexcept {
  status.last_reject = report;
  switch (report.status) {
    case FrameStatus::kWrongGeneration:
      ++status.counts.wrong_generation;
      break;
    case FrameStatus::kWrongLength:
      ++status.counts.wrong_length;
      break;
    default:
      ++status.counts.corrupt;
  }
}

}  // namespace surefoot
