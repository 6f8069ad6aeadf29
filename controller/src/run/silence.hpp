// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

#include "safety/command_keeper.hpp"

namespace surefoot {

/// Judges whether a robot is silent, or this machine slow. Real-time: yes.
class Silence {
 public:
  /// A report was used. @param time [s] of the loop @param tick LowState::tick
  void heard(double time, std::uint32_t tick) noexcept {
    listened_ = 0.0;
    time_ = time;
    tick_ = tick;
  }

  /// A loop's tick without a report. A machine that stood still held the robot's side up too, so
  /// silence counts only when this program has listened for a while.
  /// @param age [s] of the newest report @param elapsed [s] since the loop's last tick
  /// @param period [s] of the loop @return has the robot fallen silent?
  bool is_stale(double age, double elapsed, double period) noexcept {
    listened_ += std::min(elapsed, 2.0 * period);
    return age > kStaleTime && listened_ > kListening;
  }

  /// May it still be forgiven? @param time [s] of the loop
  bool forgivable(double time) const noexcept { return time - time_ < kForgiven; }

  /// Was the robot's own clock silent as well, so that nothing has happened there meanwhile? A
  /// virtual robot that is held up knows this; for a real one time goes on.
  /// @param time [s] of the loop @param tick of the report after the silence
  bool stood_still(double time, std::uint32_t tick) const noexcept {
    return forgivable(time) && 1e-3 * (tick - tick_) <= kHoldTime;
  }

 private:
  static constexpr double kListening = 0.007;  // [s]
  static constexpr double kForgiven = 0.1;     // [s] of silence, at most

  double listened_ = 0.0;   // [s] without a report, in which this program ran
  double time_ = 0.0;       // [s] when the last report was used
  std::uint32_t tick_ = 0;  // of that report
};

}  // namespace surefoot
