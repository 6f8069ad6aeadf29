// SPDX-License-Identifier: BSD-3-Clause
#include "link/tick_sequence.hpp"

namespace surefoot {

namespace {
constexpr std::uint32_t kRemembered = 64;  // [ms] bits of seen_
constexpr int kRestart = 5;                // reports in a row from behind: the robot began anew
constexpr int kShorter = 2, kLonger = 8;   // equal steps in a row that make a new period
}  // namespace

TickSequence::Verdict TickSequence::take(std::uint32_t tick) noexcept {
  if (!started_) {
    begin(tick);
    return Verdict::kNewer;
  }
  const auto ahead = static_cast<std::int32_t>(tick - last_);
  return ahead > 0 ? take_ahead(tick - last_) : take_behind(tick, last_ - tick);
}

void TickSequence::begin(std::uint32_t tick) noexcept {
  started_ = true;
  last_ = tick;
  seen_ = 1;
  period_ = step_ = 0;
  steps_ = old_ones_ = 0;
}

TickSequence::Verdict TickSequence::take_ahead(std::uint32_t step) noexcept {
  learn(step);
  if (period_ > 0 && step > period_) lost_ += step / period_ - 1;
  seen_ = step < kRemembered ? (seen_ << step) | 1 : 1;
  last_ += step;
  old_ones_ = 0;
  return Verdict::kNewer;
}

TickSequence::Verdict TickSequence::take_behind(std::uint32_t tick, std::uint32_t behind) noexcept {
  if (behind < kRemembered) {
    const std::uint64_t bit = std::uint64_t{1} << behind;
    if ((seen_ & bit) != 0) return Verdict::kDuplicate;
    seen_ |= bit;
  }
  const bool rising = old_ones_ > 0 && static_cast<std::int32_t>(tick - old_) > 0;
  old_ones_ = rising ? old_ones_ + 1 : 1;
  old_ = tick;
  if (old_ones_ >= kRestart) {
    begin(tick);
    return Verdict::kRestarted;
  }
  if (lost_ > 0) --lost_;  // it had been given up
  return Verdict::kReordered;
}

// Lost reports lengthen a step, so a shorter one convinces sooner than a longer one.
void TickSequence::learn(std::uint32_t step) noexcept {
  steps_ = step == step_ ? steps_ + 1 : 1;
  step_ = step;
  const int needed = period_ == 0 || step < period_ ? kShorter : kLonger;
  if (steps_ >= needed) period_ = step;
}

}  // namespace surefoot
