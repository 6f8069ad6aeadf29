// SPDX-License-Identifier: BSD-3-Clause
#include "safety/tick_clock.hpp"

#include <algorithm>

namespace surefoot {

double TickClock::advance(std::uint32_t tick) noexcept {
  if (!started_) {
    started_ = true;
    last_ = tick;
    return 0.0;
  }
  // Unsigned subtraction wraps as the counter does; read as signed, half the range is the past.
  const auto step = static_cast<std::int32_t>(tick - last_);
  if (step <= 0) return -1.0;
  last_ = tick;
  const double seconds = 1e-3 * step;
  period_ = std::min(seconds, kMaxStep);
  return seconds;
}

}  // namespace surefoot
