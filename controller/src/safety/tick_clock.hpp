// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace surefoot {

/// Time from LowState::tick: milliseconds modulo 2^32, of which only differences mean anything.
/// Real-time: yes.
class TickClock {
 public:
  /// Take in a tick. @return seconds since the last good one; 0 for the first; negative when the
  /// tick stands still or runs backwards, and then nothing is remembered.
  double advance(std::uint32_t tick) noexcept;

  /// The usual step [s]: the last good one, at most kMaxStep.
  double period() const noexcept { return period_; }

  void reset() noexcept { *this = TickClock(); }

  static constexpr double kMaxStep = 0.010;  ///< [s] a longer gap is integrated as this

 private:
  bool started_ = false;
  std::uint32_t last_ = 0;
  double period_ = 0.002;
};

}  // namespace surefoot
