// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace surefoot {

/// Clock that reads LowState::tick, a counter of milliseconds modulo 2^32. Only differences of
/// ticks have a meaning. Real-time: yes.
class TickClock {
 public:
  /// @param jump [s] a step is a jump if it is longer than this and longer than five periods
  explicit TickClock(double jump = kJumpTime) : jump_threshold_(jump) {}

  /// Process a tick.
  ///
  /// A tick is bad if it repeats, runs backwards or jumps. A second tick shortly after a jump
  /// confirms the jump: this second tick is good, and its step counts as kMaxStep.
  /// @return time since the last good tick [s]; 0 for the first tick; negative for a bad tick
  double advance(std::uint32_t tick) noexcept;

  /// Time [s] from the last good tick to the tick of the last advance(), also for a confirmed jump.
  /// 0 for a bad tick and for the first tick.
  double gap() const noexcept { return gap_; }

  /// Period of the samples [s], at most kMaxStep: the second longest of the last four steps. So one
  /// long step (a lost sample) or up to two short steps (jitter) do not change the result. Callers
  /// also use this period as the duration of a bad tick, by which a held command grows older.
  double period() const noexcept;

  void reset() noexcept { *this = TickClock(jump_threshold_); }

  /// [s] Longest time that is integrated in one step. Equal to kHoldTime, after which the state is
  /// unknown.
  static constexpr double kMaxStep = 0.010;
  /// [s] Default of `jump`. Equal to kRobotWatchdogTime, after which the robot has damped.
  static constexpr double kJumpTime = 0.100;

 private:
  double jump_threshold_;  // [s] constructor argument `jump`
  bool started_ = false;
  bool jump_pending_ = false;
  std::uint32_t last_tick_ = 0;
  std::uint32_t jump_tick_ = 0;  // tick after the jump that waits for confirmation
  double gap_ = 0.0;
  // [s] The last four steps; the initial value is the period at 500 Hz.
  std::array<double, 4> recent_steps_ = {0.002, 0.002, 0.002, 0.002};
  int next_step_index_ = 0;
};

}  // namespace surefoot
