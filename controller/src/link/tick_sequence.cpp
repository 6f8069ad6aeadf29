// SPDX-License-Identifier: BSD-3-Clause
#include "link/tick_sequence.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr int kRestart = 5;               // reports in a row from behind: the robot began anew
constexpr double kPace = 0.5e-3;          // [s] of arrival a tick of theirs, at least
constexpr int kShorter = 2, kLonger = 8;  // equal steps in a row that make a new period
}  // namespace

TickSequence::Verdict TickSequence::take(std::uint32_t tick, double time) noexcept {
  if (!started_) {
    begin(tick);
    return Verdict::kNewer;
  }
  const auto ahead = static_cast<std::int32_t>(tick - last_);
  return ahead > 0 ? take_ahead(tick - last_) : take_behind(tick, last_ - tick, time);
}

void TickSequence::begin(std::uint32_t tick) noexcept {
  started_ = true;
  last_ = tick;
  seen_ = 1;  // the newest itself
  period_ = step_ = 0;
  steps_ = old_ones_ = 0;
}

TickSequence::Verdict TickSequence::take_ahead(std::uint32_t step) noexcept {
  learn(step);
  if (period_ > 0 && step > period_) lost_ += step / period_ - 1;
  seen_ <<= std::min<std::size_t>(step, kRemembered);
  seen_.set(0);
  last_ += step;
  old_ones_ = 0;
  return Verdict::kNewer;
}

TickSequence::Verdict TickSequence::take_behind(std::uint32_t tick, std::uint32_t behind,
                                                double time) noexcept {
  const bool recent = behind < kRemembered;
  if (recent) {
    if (seen_[behind]) return Verdict::kDuplicate;
    seen_.set(behind);
  }
  const bool rising = old_ones_ > 0 && static_cast<std::int32_t>(tick - old_) > 0;
  if (!rising) {
    old_first_ = tick;
    old_since_ = time;
  }
  old_ones_ = rising ? old_ones_ + 1 : 1;
  old_ = tick;
  const bool paced = time - old_since_ >= kPace * (tick - old_first_);
  if (old_ones_ >= kRestart && (paced || !recent)) {
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
