// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstdint>

namespace surefoot {

/// Classifies samples by LowState::tick, and counts lost samples. Real-time: yes.
///
/// LowState::tick counts milliseconds of the robot's clock. The class learns the period of the
/// samples: the difference between successive ticks, once the same difference has occurred several
/// times in a row. The robot has restarted if five consecutive samples have increasing ticks that
/// are all older than the newest tick. But ticks that are less than about 1 s older can also come
/// from late samples, which the network delivers in a burst. So such samples count as a restart
/// only if they also arrive at about the rate at which the robot sends.
class TickSequence {
 public:
  /// kNewer: the newest sample so far, or the first. kDuplicate: its tick has arrived before.
  /// kReordered: a late sample. kRestarted: the first sample of a restarted robot that is used.
  enum class Arrival { kNewer, kDuplicate, kReordered, kRestarted };

  /// Classify a valid sample by its tick.
  /// @param tick LowState::tick of the sample [ms]
  /// @param time arrival time of the sample [s], on any steady clock
  Arrival classify(std::uint32_t tick, double time) noexcept;

  /// Forget the ticks so far, because the next sample comes from a restarted robot.
  void restart() noexcept { started_ = false; }

  /// Return the number of samples that have been lost since the first call of classify().
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  void begin(std::uint32_t tick) noexcept;
  Arrival classify_ahead(std::uint32_t step) noexcept;
  // @param behind how much `tick` is older than the newest tick [ms]
  Arrival classify_behind(std::uint32_t tick, std::uint32_t behind, double time) noexcept;
  void update_period(std::uint32_t step) noexcept;

  // [ms] Length of the window of remembered ticks. Chosen: about 1 s. Samples older than this
  // cannot be distinguished from samples after a restart.
  static constexpr std::size_t kWindow = 1024;

  bool started_ = false;
  std::uint32_t newest_tick_ = 0;
  std::bitset<kWindow> received_;     // bit k: the sample with tick newest_tick_ - k has arrived
  std::uint32_t period_ = 0;          // [ms] period of the samples; 0: not known yet
  std::uint32_t step_ = 0;            // [ms] last difference of successive ticks
  int step_repeats_ = 0;              // number of consecutive equal differences
  std::uint32_t last_old_tick_ = 0;   // [ms] last tick of the present series of old samples
  int old_count_ = 0;                 // number of samples in this series
  std::uint32_t first_old_tick_ = 0;  // [ms] first tick of this series
  double first_old_time_ = 0.0;       // [s] arrival time of the first sample of this series
  std::uint64_t lost_ = 0;
};

}  // namespace surefoot
