// SPDX-License-Identifier: BSD-3-Clause
#include "gait/gait_timing.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

// Largest speed of a minimum-jerk motion, divided by its mean speed. Derived: 15/8.
constexpr double kPeakSpeed = 1.875;
// [sqrt(g h)] Speed below which timing does not change. Numerical: avoids a division by zero.
constexpr double kMinSpeed = 1e-3;
// Smallest ratio of stance to swing time. Chosen: with less, a pair of feet would have to
// carry more than 1.6 times the weight.
constexpr double kMinStanceRatio = 0.45;

// Smallest duty of a walk. Derived: one of four feet swings at a time.
constexpr double kMinWalkDuty = 0.75;

// Offsets of a walk: the feet lift off in this order, a quarter of the period apart. The last one
// swings from phase 0 on, so at the start of the clock it skips its swing, and a quarter of the
// period is left to shift the body.
std::array<double, kLegs> walk_offsets(const WalkOrder& order, double duty) noexcept {
  std::array<double, kLegs> offsets;
  for (int k = 0; k < kLegs; ++k) {
    const double lift_off = 0.25 * (k + 1);
    offsets[order[k]] = duty - lift_off - std::floor(duty - lift_off);
  }
  return offsets;
}

}  // namespace

GaitTiming gait_timing(const StepPattern& pattern, const Gains& gains, const GaitSize& size,
                       const WalkVelocity& velocity) noexcept {
  const bool walk = pattern.walk;
  const double speed = std::max(size.fastest_hip(velocity), kMinSpeed * size.speed);
  // A swing foot travels speed * period in the swing time, with the peak kPeakSpeed times the mean:
  //   kPeakSpeed * speed * (stance + swing) / swing - speed <= swing_speed
  const double swing_speed = gains.gait_swing_speed * size.height * size.corner_speed;
  const double ratio = std::max((swing_speed / speed + 1.0) / kPeakSpeed - 1.0, kMinStanceRatio);
  GaitTiming timing;
  timing.duty = std::min(walk ? gains.walk_gait_duty : gains.gait_duty, ratio / (1.0 + ratio));
  if (walk) {
    timing.duty = std::max(timing.duty, kMinWalkDuty);
    timing.offset = walk_offsets(pattern.order, timing.duty);
  }
  timing.period = std::min((walk ? gains.walk_gait_period : gains.gait_period) * size.time,
                           gains.gait_stance_travel * size.height / speed / timing.duty);
  return timing;
}

}  // namespace surefoot
