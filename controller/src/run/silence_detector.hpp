// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "common/command_times.hpp"

namespace surefoot {

/// Detector of a silent robot, as opposed to a machine that stalled. Real-time: yes.
class SilenceDetector {
 public:
  /// Record that a sample was used. @param time of the loop [s] @param tick its LowState::tick
  void on_sample(double time, std::uint32_t tick) noexcept {
    listening_time_ = 0.0;
    last_sample_time_ = time;
    last_tick_ = tick;
  }

  /// Return whether the robot is silent; call it in each tick of the loop without a sample.
  ///
  /// A stall of this machine also delays a robot simulated on it. So silence counts only after this
  /// process has listened for kMinListeningTime.
  /// @param age of the newest sample [s]
  /// @param elapsed time since the last tick of the loop [s]
  /// @param period of the loop [s]
  bool is_stale(double age, double elapsed, double period) noexcept {
    listening_time_ += std::min(elapsed, 2.0 * period);
    return age > kStaleTime && listening_time_ > kMinListeningTime;
  }

  /// Return whether the silence is short enough to resume control. @param time of the loop [s]
  bool recoverable(double time) const noexcept {
    return time - last_sample_time_ < kMaxRecoverableSilence;
  }

  /// Return whether the robot's clock paused during the silence, so that the robot has not moved.
  /// The clock of a virtual robot pauses with its process; the clock of a real robot does not.
  /// @param time of the loop [s]
  /// @param tick LowState::tick of the sample after the silence
  bool robot_clock_paused(double time, std::uint32_t tick) const noexcept {
    return recoverable(time) && 1e-3 * (tick - last_tick_) <= kHoldTime;
  }

 private:
  static constexpr double kMinListeningTime = 0.007;     // [s]
  static constexpr double kMaxRecoverableSilence = 0.1;  // [s] longest before control resumes

  double listening_time_ = 0.0;    // [s] without a sample, in which this process ran
  double last_sample_time_ = 0.0;  // [s] when the last sample was used
  std::uint32_t last_tick_ = 0;    // of that sample
};

}  // namespace surefoot
