// SPDX-License-Identifier: BSD-3-Clause
#include "link/tick_sequence.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr std::int32_t kRestart = 1000;  // [ms] backwards: the robot has begun to count anew
constexpr std::uint32_t kPause = 1000;   // [ms] forwards: it was away, and nothing was lost
}  // namespace

TickSequence::Verdict TickSequence::take(std::uint32_t tick) noexcept {
  const auto ahead = static_cast<std::int32_t>(tick - last_);
  if (!started_ || ahead <= -kRestart) {
    const Verdict verdict = started_ ? Verdict::kRestarted : Verdict::kNewer;
    started_ = true;
    last_ = tick;
    step_ = 0;
    return verdict;
  }
  if (ahead == 0) return Verdict::kDuplicate;
  if (ahead < 0) {
    if (lost_ > 0) --lost_;  // it had been given up
    return Verdict::kReordered;
  }
  const auto step = static_cast<std::uint32_t>(ahead);
  step_ = step_ == 0 ? step : std::min(step_, step);
  if (step < kPause) lost_ += step / step_ - 1;
  last_ = tick;
  return Verdict::kNewer;
}

}  // namespace surefoot
