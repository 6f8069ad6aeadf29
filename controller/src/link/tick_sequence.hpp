// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace surefoot {

/// Tells from LowState::tick what became of the reports in between. Real-time: yes.
class TickSequence {
 public:
  enum class Verdict { kNewer, kDuplicate, kReordered, kRestarted };

  /// Take in the tick of a valid report.
  Verdict take(std::uint32_t tick) noexcept;

  /// Reports that should have come since take() was first called, and have not (yet).
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  bool started_ = false;
  std::uint32_t last_ = 0;
  std::uint32_t step_ = 0;  // [ms] between reports: the least that was seen
  std::uint64_t lost_ = 0;
};

}  // namespace surefoot
