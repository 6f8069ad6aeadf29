// SPDX-License-Identifier: BSD-3-Clause
#include "gait/gait_clock.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [period] Longest wait for late feet. Chosen: a foot that meets no ground within this time, 60 ms
// of a period of 0.42 s, has stepped into a hole.
constexpr double kMaxWait = 0.15;

}  // namespace

void GaitClock::advance(const GaitTiming& timing, bool late, bool stop, double dt) noexcept {
  timing_ = timing;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (phase_of(leg) < timing_.duty) grounded_[leg] = stop;
  }
  const double step = dt / timing_.period;
  bool lifts = false;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double phase = phase_of(leg);
    const bool ends = phase < timing_.duty && phase + step >= timing_.duty;
    lifts = lifts || (ends && !stop);
  }
  if (lifts && late && waited_ < kMaxWait * timing_.period) {
    waited_ += dt;
    return;
  }
  if (lifts || stop) waited_ = 0.0;
  phase_ = fraction(phase_ + step);
}

double GaitClock::phase_of(int leg) const noexcept {
  return fraction(phase_ + timing_.offset[leg]);
}

double GaitClock::swing_progress(int leg) const noexcept {
  return in_swing(leg) ? (phase_of(leg) - timing_.duty) / (1.0 - timing_.duty) : 0.0;
}

double GaitClock::time_to_touchdown(int leg) const noexcept {
  return in_swing(leg) ? (1.0 - phase_of(leg)) * timing_.period : 0.0;
}

double GaitClock::time_since_touchdown(int leg) const noexcept {
  return in_swing(leg) ? 0.0 : phase_of(leg) * timing_.period;
}

double GaitClock::time_to_liftoff(int leg) const noexcept {
  if (grounded_[leg]) return timing_.period;
  return std::max(timing_.duty - phase_of(leg), 0.0) * timing_.period;
}

}  // namespace surefoot
