// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "common/command_times.hpp"

namespace surefoot {

/// Detects silence: a robot that sends no samples although this process listens. A stall of this
/// machine does not count as silence. Real-time: yes.
class SilenceDetector {
 public:
  /// Record that a sample was used.
  /// @param time present time of the loop [s]
  /// @param tick LowState::tick of the sample
  void on_sample(double time, std::uint32_t tick) noexcept {
    listening_time_ = 0.0;
    last_sample_time_ = time;
    last_tick_ = tick;
  }

  /// Return whether the robot is silent. Call this in each tick of the loop that has no sample.
  ///
  /// While this machine stalls, this process does not read samples, and a robot that is simulated
  /// on this machine does not send any. So silence counts only after this process has listened for
  /// more than kMinListeningTime. A long tick counts as at most two periods of listening.
  /// @param age age of the newest sample [s]
  /// @param elapsed time since the last tick of the loop [s]
  /// @param period period of the loop [s]
  bool is_silent(double age, double elapsed, double period) noexcept {
    listening_time_ += std::min(elapsed, 2.0 * period);
    return age > kStaleTime && listening_time_ > kMinListeningTime;
  }

  /// Return whether the silence is short enough to resume control. @param time time of the loop [s]
  bool recoverable(double time) const noexcept {
    return time - last_sample_time_ < kMaxRecoverableSilence;
  }

  /// Return whether the robot's clock paused during the silence. If it did, the robot has not
  /// moved. The clock of a virtual robot pauses with the process of this robot; the clock of a real
  /// robot never pauses.
  /// @param time present time of the loop [s]
  /// @param tick LowState::tick of the sample after the silence
  bool robot_clock_paused(double time, std::uint32_t tick) const noexcept {
    return recoverable(time) && 1e-3 * (tick - last_tick_) <= kHoldTime;
  }

 private:
  // [s] Listening time above which silence counts. Chosen: it is exceeded after four ticks of the
  // loop at 500 Hz. If shorter: a sample could still wait in the socket. Upper limit:
  // test_silent_robot_is_stale_within_60_ms_at_every_rate.
  static constexpr double kMinListeningTime = 0.007;
  // [s] Longest silence after which control may resume. Equal to kRobotWatchdogTime.
  static constexpr double kMaxRecoverableSilence = 0.1;

  double listening_time_ = 0.0;    // [s] time for which this process has run without a sample
  double last_sample_time_ = 0.0;  // [s] time of the loop when the last sample was used
  std::uint32_t last_tick_ = 0;    // LowState::tick of the last sample that was used
};

}  // namespace surefoot
