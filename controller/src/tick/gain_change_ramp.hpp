// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/gains.hpp"

namespace surefoot {

/// Linear ramp from the active gains to the requested gains, so that torques do not jump.
///
/// The ranges of the gains are convex, so a mix of two valid gain sets is valid up to rounding.
/// Real-time: yes.
class GainChangeRamp {
 public:
  /// [s] Duration of the ramp. Chosen. If shorter: torques change in few ticks and so jump. If
  /// longer: an operator waits too long for the change.
  static constexpr double kRampTime = 0.1;

  void start(const Gains& from, const Gains& to) noexcept {
    start_ = from;
    target_ = to;
    remaining_ = kRampTime;
  }
  bool moving() const noexcept { return remaining_ > 0.0; }
  const Gains& target() const noexcept { return target_; }

  /// Advance the ramp by dt [s] and return the active gains. After the ramp they equal target().
  const Gains& step(double dt) noexcept {
    remaining_ = std::max(remaining_ - dt, 0.0);
    current_ = target_;
    if (remaining_ > 0.0) {
      const double fraction = 1.0 - remaining_ / kRampTime;
      for (const GainInfo& info : gain_table()) {
        const double from = start_.*info.member;
        current_.*info.member = from + fraction * (target_.*info.member - from);
      }
    }
    return current_;
  }

 private:
  Gains start_, target_, current_;
  double remaining_ = 0.0;  // [s]
};

}  // namespace surefoot
