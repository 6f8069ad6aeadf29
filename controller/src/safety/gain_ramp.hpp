// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/gains.hpp"

namespace surefoot {

/// Gains on their way from those in force to those asked for, so that torques do not jump.
///
/// Straight, over kRampTime: ranges are convex, so what lies between valid gains is valid but for
/// rounding. Real-time: yes.
class GainRamp {
 public:
  static constexpr double kRampTime = 0.1;  ///< [s] long beside a tick, short beside a hand

  void start(const Gains& from, const Gains& to) noexcept {
    start_ = from;
    target_ = to;
    remaining_ = kRampTime;
  }
  bool moving() const noexcept { return remaining_ > 0.0; }
  const Gains& target() const noexcept { return target_; }

  /// Go on by dt [s] and return the gains of now; the last are exactly those asked for.
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
