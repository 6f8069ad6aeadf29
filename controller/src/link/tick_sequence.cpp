// SPDX-License-Identifier: BSD-3-Clause
#include "link/tick_sequence.hpp"

#include <algorithm>

namespace surefoot {

namespace {
// Number of consecutive old samples that show a restart. Chosen: a smaller number could come from
// reordered samples; with a larger number the robot would be without control for longer than 10 ms
// at 500 Hz. Test: test_tick_sequence.cpp.
constexpr int kRestartSamples = 5;
// [s/ms] Time from the first to the last arrival of these samples, divided by the difference of
// their ticks; at least this shows a restart. Derived: half of 1e-3, the value of samples that
// arrive as the robot sends them. Late samples in a burst arrive faster.
constexpr double kMinArrivalSpacing = 0.5e-3;
// Number of consecutive equal steps that set a new period. Chosen: a smaller number could come from
// single lost samples; with a larger number, lost samples would be miscounted for longer. Test:
// test_tick_sequence.cpp.
constexpr int kStepsToShortenPeriod = 2, kStepsToLengthenPeriod = 8;
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
  received_ = 1;  // bit 0: the newest sample itself
  period_ = step_ = 0;
  step_repeats_ = old_count_ = 0;
}

TickSequence::Arrival TickSequence::classify_ahead(std::uint32_t step) noexcept {
  update_period(step);
  if (period_ > 0 && step > period_) lost_ += step / period_ - 1;
  received_ <<= std::min<std::size_t>(step, kWindow);
  received_.set(0);
  newest_tick_ += step;
  old_count_ = 0;
  return Arrival::kNewer;
}

TickSequence::Arrival TickSequence::classify_behind(std::uint32_t tick, std::uint32_t behind,
                                                    double time) noexcept {
  const bool recent = behind < kWindow;
  if (recent) {
    if (received_[behind]) return Arrival::kDuplicate;
    received_.set(behind);
  }
  const bool increasing = old_count_ > 0 && static_cast<std::int32_t>(tick - last_old_tick_) > 0;
  if (!increasing) {
    first_old_tick_ = tick;
    first_old_time_ = time;
  }
  old_count_ = increasing ? old_count_ + 1 : 1;
  last_old_tick_ = tick;
  // True if the old samples arrive at the pace of the robot's clock and not in a burst.
  const bool at_clock_pace =
      time - first_old_time_ >= kMinArrivalSpacing * (tick - first_old_tick_);
  if (old_count_ >= kRestartSamples && (at_clock_pace || !recent)) {
    begin(tick);
    return Arrival::kRestarted;
  }
  if (lost_ > 0) --lost_;  // the late sample was counted as lost
  return Arrival::kReordered;
}

// Learn the period. A step longer than the present period may come from lost samples, but a shorter
// step cannot. So a shorter step needs fewer repetitions to become the new period.
void TickSequence::update_period(std::uint32_t step) noexcept {
  step_repeats_ = step == step_ ? step_repeats_ + 1 : 1;
  step_ = step;
  const int needed =
      period_ == 0 || step < period_ ? kStepsToShortenPeriod : kStepsToLengthenPeriod;
  if (step_repeats_ >= needed) period_ = step;
}

}  // namespace surefoot
