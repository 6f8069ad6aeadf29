// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "link/tick_sequence.hpp"
#include "surefoot/robot_link.hpp"

namespace surefoot {

/// Keeps the newest LowState of a link and counts all of them in LinkStatus. Real-time: yes.
class StateIntake {
 public:
  /// Count a valid LowState, and store it if it is newer than the stored one or if the robot has
  /// restarted. Duplicate and reordered LowStates are only counted.
  /// @param time arrival time [s], on monotonic_time()
  /// @param ticks_show_losses false: the tick was made from the arrival time, so its jitter is not
  /// counted as lost LowStates
  /// @return true if the LowState was stored
  bool accept(const LowState& incoming, double time, bool ticks_show_losses = true) noexcept;
  /// Count a restart of the robot. The next valid LowState is stored, whatever its tick is.
  void restart() noexcept {
    ++status.counts.restarts;
    sequence_.restart();
  }
  /// Count and store the reason why a message was rejected.
  void reject(const FrameReport& report) noexcept;

  LinkStatus status;  ///< status of the link; the link itself counts what it sends

 private:
  TickSequence sequence_;
};

}  // namespace surefoot
