// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace surefoot {

/// Clock that reads LowState::tick: milliseconds modulo 2^32, of which only differences have a
/// meaning. Real-time: yes.
class TickClock {
 public:
  /// @param jump [s] a step longer than this, and than five periods, is a jump
  explicit TickClock(double jump = kJumpTime) : jump_threshold_(jump) {}

  /// Process a tick.
  ///
  /// A tick that repeats, runs backwards or jumps is bad. A second tick shortly after a jump
  /// confirms the jump; it is good and counts as kMaxStep.
  /// @return time since the last good tick [s]; 0 for the first tick; negative for a bad tick
  double advance(std::uint32_t tick) noexcept;

  /// Result of the last advance() [s], but with the whole time of a confirmed jump; 0 if the tick
  /// was bad or the first.
  double gap() const noexcept { return gap_; }

  /// Assumed duration of a bad tick [s], at most kMaxStep: the second longest of the last four
  /// steps. A short step after jitter must not prolong the life of an old command. One lost sample
  /// must not double the speed at which the command ages.
  double period() const noexcept;

  void reset() noexcept { *this = TickClock(jump_threshold_); }

  static constexpr double kMaxStep = 0.010;   ///< [s] longest time that is integrated
  static constexpr double kJumpTime = 0.100;  ///< [s] default of `jump`

 private:
  double jump_threshold_;  // [s] longest step that is not a jump
  bool started_ = false;
  bool jump_pending_ = false;
  std::uint32_t last_ = 0;
  std::uint32_t jump_tick_ = 0;
  double gap_ = 0.0;
  std::array<double, 4> recent_steps_ = {0.002, 0.002, 0.002, 0.002};
  int next_ = 0;
};

}  // namespace surefoot
