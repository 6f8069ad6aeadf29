// SPDX-License-Identifier: BSD-3-Clause
#include "gait/gait_clock.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// [period] Longest wait for late feet. Chosen: a foot that meets no ground within this time, 60 ms
// of a period of 0.42 s, has stepped into a hole.
constexpr double kMaxWait = 0.15;

double fraction(double value) noexcept { return value - std::floor(value); }

}  // namespace

void GaitClock::advance(const GaitTiming& timing, bool late, double dt) noexcept {
  timing_ = timing;
  const double step = dt / timing_.period;
  bool lifts = false;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double phase = phase_of(leg);
    lifts = lifts || (phase < timing_.duty && phase + step >= timing_.duty);
  }
  if (lifts && late && waited_ < kMaxWait * timing_.period) {
    waited_ += dt;
    return;
  }
  if (lifts) waited_ = 0.0;
  phase_ = fraction(phase_ + step);
}

double GaitClock::phase_of(int leg) const noexcept {
  return fraction(phase_ + timing_.offset[leg]);
}

double GaitClock::swing_progress(int leg) const noexcept {
  return std::max(phase_of(leg) - timing_.duty, 0.0) / (1.0 - timing_.duty);
}

double GaitClock::time_to_touchdown(int leg) const noexcept {
  return in_swing(leg) ? (1.0 - phase_of(leg)) * timing_.period : 0.0;
}

double GaitClock::time_to_liftoff(int leg) const noexcept {
  return std::max(timing_.duty - phase_of(leg), 0.0) * timing_.period;
}

double GaitClock::time_since_touchdown(int leg) const noexcept {
  return in_swing(leg) ? 0.0 : phase_of(leg) * timing_.period;
}

bool GaitClock::all_in_stance() const noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    if (in_swing(leg)) return false;
  }
  return true;
}

}  // namespace surefoot
