// SPDX-License-Identifier: BSD-3-Clause
#include "safety/tick_clock.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// [s] Numerical: tolerance for the rounding of summed periods, which are whole milliseconds.
constexpr double kRounding = 1e-9;
// [periods] A step of at most this many periods is never a jump. Chosen. If smaller: samples that a
// slow loop loses count as a jump. If larger: the jump of a clock is accepted. Test:
// test_tick_clock.cpp.
constexpr double kJumpPeriods = 5.0;

// Return the time [s] from one tick to another, negative if `to` is earlier. The unsigned
// subtraction and the counter both wrap around at 2^32, so the difference is right.
double seconds_between(std::uint32_t from, std::uint32_t to) noexcept {
  return 1e-3 * static_cast<std::int32_t>(to - from);
}

}  // namespace

double TickClock::advance(std::uint32_t tick) noexcept {
  if (!started_) {
    started_ = true;
    last_tick_ = tick;
    return 0.0;
  }
  double step = seconds_between(last_tick_, tick);
  gap_ = 0.0;
  const double max_step = std::max(jump_threshold_, kJumpPeriods * period()) + kRounding;
  if (step > max_step) {
    const double since_jump = seconds_between(jump_tick_, tick);
    const bool confirmed = jump_pending_ && since_jump > 0.0 && since_jump <= max_step;
    jump_pending_ = true;
    jump_tick_ = tick;
    if (!confirmed) return -1.0;
    gap_ = step;
    step = kMaxStep;
  }
  if (step <= 0.0) return -1.0;
  jump_pending_ = false;
  gap_ = std::max(gap_, step);
  last_tick_ = tick;
  recent_steps_[next_step_index_] = std::min(step, kMaxStep);
  next_step_index_ = (next_step_index_ + 1) % static_cast<int>(recent_steps_.size());
  return step;
}

double TickClock::period() const noexcept {
  std::array<double, 4> steps = recent_steps_;
  std::sort(steps.begin(), steps.end());
  return steps[2];
}

}  // namespace surefoot
