// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstdint>

namespace surefoot {

/// Tells from LowState::tick what became of the reports in between. Real-time: yes.
///
/// Ticks count milliseconds, so how many of them make one report is learnt: the step that comes
/// time after time. A robot that begins anew is told from reports that were held up on the way by
/// coming in a row: ticks that rise, all of them behind what came before. Where they may be the
/// last second's own, which a network delivers in a burst, they must come at the robot's pace, too.
class TickSequence {
 public:
  enum class Arrival { kNewer, kDuplicate, kReordered, kRestarted };

  /// Take in the tick of a valid report. @param time of its arrival [s], on any steady clock
  Arrival classify(std::uint32_t tick, double time) noexcept;

  /// Reports that should have come since classify() was first called, and have not (yet).
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  void begin(std::uint32_t tick) noexcept;
  Arrival classify_ahead(std::uint32_t step) noexcept;
  Arrival classify_behind(std::uint32_t tick, std::uint32_t behind, double time) noexcept;
  void update_period(std::uint32_t step) noexcept;

  static constexpr std::size_t kWindow = 1024;  // [ms]

  bool started_ = false;
  std::uint32_t newest_tick_ = 0;        // the newest
  std::bitset<kWindow> received_;        // bit k: has newest_tick_ - k come?
  std::uint32_t period_ = 0;             // [ms] between reports; 0: not known yet
  std::uint32_t step_ = 0;               // [ms] between the newest two
  int step_repeats_ = 0;                 // how many of the same in a row
  std::uint32_t behind_tick_ = 0;        // the newest of those in a row that are behind
  int behind_count_ = 0;                 // how many
  std::uint32_t behind_first_tick_ = 0;  // the first of them ...
  double behind_start_time_ = 0.0;       // [s] ... and when it came
  std::uint64_t lost_ = 0;
};

}  // namespace surefoot
