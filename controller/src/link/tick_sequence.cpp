// SPDX-License-Identifier: BSD-3-Clause
#include "link/tick_sequence.hpp"

#include <algorithm>

namespace surefoot {

namespace {
constexpr int kRestartSamples = 5;           // old samples in a row that show a restart
constexpr double kMinTickDuration = 0.5e-3;  // [s] least arrival time per tick of that row
constexpr int kStepsToShortenPeriod = 2,
              kStepsToLengthenPeriod = 8;  // equal steps in a row for a new period
}  // namespace

TickSequence::Arrival TickSequence::classify(std::uint32_t tick, double time) noexcept {
  if (!started_) {
    begin(tick);
    return Arrival::kNewer;
  }
  const auto ahead = static_cast<std::int32_t>(tick - newest_tick_);
  return ahead > 0 ? classify_ahead(tick - newest_tick_)
                   : classify_behind(tick, newest_tick_ - tick, time);
}

void TickSequence::begin(std::uint32_t tick) noexcept {
  started_ = true;
  newest_tick_ = tick;
  received_ = 1;  // the newest itself
  period_ = step_ = 0;
  step_repeats_ = behind_count_ = 0;
}

TickSequence::Arrival TickSequence::classify_ahead(std::uint32_t step) noexcept {
  update_period(step);
  if (period_ > 0 && step > period_) lost_ += step / period_ - 1;
  received_ <<= std::min<std::size_t>(step, kWindow);
  received_.set(0);
  newest_tick_ += step;
  behind_count_ = 0;
  return Arrival::kNewer;
}

TickSequence::Arrival TickSequence::classify_behind(std::uint32_t tick, std::uint32_t behind,
                                                    double time) noexcept {
  const bool recent = behind < kWindow;
  if (recent) {
    if (received_[behind]) return Arrival::kDuplicate;
    received_.set(behind);
  }
  const bool rising = behind_count_ > 0 && static_cast<std::int32_t>(tick - behind_tick_) > 0;
  if (!rising) {
    behind_first_tick_ = tick;
    behind_start_time_ = time;
  }
  behind_count_ = rising ? behind_count_ + 1 : 1;
  behind_tick_ = tick;
  const bool paced = time - behind_start_time_ >= kMinTickDuration * (tick - behind_first_tick_);
  if (behind_count_ >= kRestartSamples && (paced || !recent)) {
    begin(tick);
    return Arrival::kRestarted;
  }
  if (lost_ > 0) --lost_;  // it was counted as lost
  return Arrival::kReordered;
}

// Lost samples lengthen a step, so a shorter step needs fewer repetitions than a longer one.
void TickSequence::update_period(std::uint32_t step) noexcept {
  step_repeats_ = step == step_ ? step_repeats_ + 1 : 1;
  step_ = step;
  const int needed =
      period_ == 0 || step < period_ ? kStepsToShortenPeriod : kStepsToLengthenPeriod;
  if (step_repeats_ >= needed) period_ = step;
}

}  // namespace surefoot
