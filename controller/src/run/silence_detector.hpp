// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "common/command_times.hpp"

namespace surefoot {

/// Judges whether a robot is silent, or this machine slow. Real-time: yes.
class SilenceDetector {
 public:
  /// A report was used. @param time [s] of the loop @param tick LowState::tick
  void on_sample(double time, std::uint32_t tick) noexcept {
    listening_time_ = 0.0;
    last_sample_time_ = time;
    last_tick_ = tick;
  }

  /// A loop's tick without a report. A machine that stood still held the robot's side up too, so
  /// silence counts only when this program has listened for a while.
  /// @param age [s] of the newest report @param elapsed [s] since the loop's last tick
  /// @param period [s] of the loop @return has the robot fallen silent?
  bool is_stale(double age, double elapsed, double period) noexcept {
    listening_time_ += std::min(elapsed, 2.0 * period);
    return age > kStaleTime && listening_time_ > kMinListeningTime;
  }

  /// May it still be forgiven? @param time [s] of the loop
  bool recoverable(double time) const noexcept {
    return time - last_sample_time_ < kMaxRecoverableSilence;
  }

  /// Was the robot's own clock silent as well, so that nothing has happened there meanwhile? A
  /// virtual robot that is held up knows this; for a real one time goes on.
  /// @param time [s] of the loop @param tick of the report after the silence
  bool robot_clock_paused(double time, std::uint32_t tick) const noexcept {
    return recoverable(time) && 1e-3 * (tick - last_tick_) <= kHoldTime;
  }

 private:
  static constexpr double kMinListeningTime = 0.007;     // [s]
  static constexpr double kMaxRecoverableSilence = 0.1;  // [s] of silence, at most

  double listening_time_ = 0.0;    // [s] without a report, in which this program ran
  double last_sample_time_ = 0.0;  // [s] when the last report was used
  std::uint32_t last_tick_ = 0;    // of that report
};

}  // namespace surefoot
