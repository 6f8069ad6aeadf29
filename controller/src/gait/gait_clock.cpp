// SPDX-License-Identifier: BSD-3-Clause
#include "gait/gait_clock.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

void GaitClock::continue_swing(const GaitTiming& timing, int leg) noexcept {
  const double progress = swing_progress(leg);
  start_swing(timing, leg);
  phase_ = fraction(phase_ + progress * (1.0 - timing.duty));
  for (int other = 0; other < kLegs; ++other) grounded_[other] = other != leg && in_swing(other);
}

void GaitClock::advance(const GaitTiming& timing, double max_wait, bool stop, double dt) noexcept {
  timing_ = timing;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (phase_of(leg) < timing_.duty || waits_[leg]) grounded_[leg] = stop;
  }
  if (std::any_of(waits_.begin(), waits_.end(), [](bool waits) { return waits; })) {
    waited_ += dt;
    if (unloaded_ == 0.0 && waited_ < max_wait) return;
    unloaded_ += dt;
    if (unloaded_ < kUnloadingTime) return;
    waits_.fill(false);
  }
  waited_ = unloaded_ = 0.0;
  const double step = dt / timing_.period;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double phase = phase_of(leg);
    const bool ends = phase < timing_.duty && phase + step >= timing_.duty;
    waits_[leg] = ends && !grounded_[leg] && max_wait > 0.0;
  }
  phase_ = fraction(phase_ + step);
}

double GaitClock::phase_of(int leg) const noexcept {
  return fraction(phase_ + timing_.offset[leg]);
}

double GaitClock::swing_progress(int leg) const noexcept {
  return in_swing(leg) ? (phase_of(leg) - timing_.duty) / (1.0 - timing_.duty) : 0.0;
}

double GaitClock::stance_progress(int leg) const noexcept {
  return std::min(phase_of(leg) / timing_.duty, 1.0);
}

double GaitClock::time_to_touchdown(int leg) const noexcept {
  return in_swing(leg) ? (1.0 - phase_of(leg)) * timing_.period : 0.0;
}

double GaitClock::time_since_touchdown(int leg) const noexcept {
  return in_swing(leg) ? 0.0 : phase_of(leg) * timing_.period;
}

double GaitClock::time_to_liftoff(int leg) const noexcept {
  if (waits_[leg] && unloaded_ > 0.0) return kUnloadingTime - unloaded_;
  if (grounded_[leg] || waits_[leg]) return timing_.period;
  return std::max(timing_.duty - phase_of(leg), 0.0) * timing_.period;
}

}  // namespace surefoot
