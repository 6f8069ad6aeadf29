// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace surefoot {

/// Makes LowState::tick from arrival times, for robots whose tick stands at 0. Real-time: yes.
class ArrivalTick {
 public:
  /// Return the tick of a LowState: milliseconds since the first one, and at least 1 more than the
  /// previous tick, so that every LowState counts as a new one.
  /// @param time arrival time [s]
  std::uint32_t next(double time) noexcept {
    if (last_ == 0) start_ = time;
    const double elapsed = std::round(1e3 * (time - start_));
    last_ = std::max(last_ + 1, 1 + static_cast<std::uint32_t>(std::max(elapsed, 0.0)));
    return last_;
  }

 private:
  double start_ = 0.0;      // [s] arrival of the first LowState
  std::uint32_t last_ = 0;  // last tick; 0: none yet
};

}  // namespace surefoot
