// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace surefoot {

/// Time from LowState::tick: milliseconds modulo 2^32, of which only differences mean anything.
/// Real-time: yes.
class TickClock {
 public:
  /// @param jump [s] a step beyond it, and beyond five periods, is a leap
  explicit TickClock(double jump = kJumpTime) : jump_threshold_(jump) {}

  /// Take in a tick. @return seconds since the last good one; 0 for the first; negative when the
  /// tick stands still, runs backwards, or leaps to where the next tick does not
  /// confirm it. A leap that is confirmed counts as kMaxStep.
  double advance(std::uint32_t tick) noexcept;

  /// What advance() just told, before it was cut down to kMaxStep: how long no good tick came [s].
  double gap() const noexcept { return gap_; }

  /// What a tick that tells no time is taken to last [s], at most kMaxStep: the second longest of
  /// the last four steps. Reports may jitter, and an old command must not live longer for it; but
  /// one that was lost must not make the next age twice as fast.
  double period() const noexcept;

  void reset() noexcept { *this = TickClock(jump_threshold_); }

  static constexpr double kMaxStep = 0.010;   ///< [s] a longer gap is integrated as this
  static constexpr double kJumpTime = 0.100;  ///< [s]

 private:
  double jump_threshold_;  // [s] step that is no leap
  bool started_ = false;
  bool jump_pending_ = false;
  std::uint32_t last_ = 0;
  std::uint32_t jump_tick_ = 0;
  double gap_ = 0.0;
  std::array<double, 4> recent_steps_ = {0.002, 0.002, 0.002, 0.002};
  int next_ = 0;
};

}  // namespace surefoot
