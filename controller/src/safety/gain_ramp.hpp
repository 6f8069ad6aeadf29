// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "surefoot/gains.hpp"

namespace surefoot {

/// Gains on their way from those in force to those asked for, so that torques do not jump.
///
/// Straight, over kTime: ranges are convex, so what lies between valid gains is valid but for
/// rounding. Real-time: yes.
class GainRamp {
 public:
  static constexpr double kTime = 0.1;  ///< [s] long beside a tick, short beside a hand

  void start(const Gains& from, const Gains& to) noexcept {
    from_ = from;
    to_ = to;
    left_ = kTime;
  }
  bool moving() const noexcept { return left_ > 0.0; }
  const Gains& target() const noexcept { return to_; }

  /// Go on by dt [s] and return the gains of now; the last are exactly those asked for.
  const Gains& step(double dt) noexcept {
    left_ = std::max(left_ - dt, 0.0);
    now_ = to_;
    if (left_ > 0.0) {
      const double way = 1.0 - left_ / kTime;
      for (const GainInfo& info : gain_table()) {
        const double from = from_.*info.member;
        now_.*info.member = from + way * (to_.*info.member - from);
      }
    }
    return now_;
  }

 private:
  Gains from_, to_, now_;
  double left_ = 0.0;  // [s]
};

}  // namespace surefoot
