// SPDX-License-Identifier: BSD-3-Clause
#include "safety/tick_clock.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// Unsigned subtraction wraps as the counter does; read as signed, half the range is the past.
double seconds_between(std::uint32_t from, std::uint32_t to) noexcept {
  return 1e-3 * static_cast<std::int32_t>(to - from);
}

}  // namespace

double TickClock::advance(std::uint32_t tick) noexcept {
  if (!started_) {
    started_ = true;
    last_ = tick;
    return 0.0;
  }
  double step = seconds_between(last_, tick);
  if (step > kLeap) {
    const double since_leap = seconds_between(leap_, tick);
    const bool confirmed = leapt_ && since_leap > 0.0 && since_leap <= kLeap;
    leapt_ = true;
    leap_ = tick;
    if (!confirmed) return -1.0;
    step = kMaxStep;
  }
  if (step <= 0.0) return -1.0;
  leapt_ = false;
  last_ = tick;
  previous_step_ = step_;
  step_ = std::min(step, kMaxStep);
  return step;
}

double TickClock::period() const noexcept { return std::max(step_, previous_step_); }

}  // namespace surefoot
