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

}  // namespace

GaitTiming trot_timing(const Gains& gains, const GaitSize& size,
                       const WalkVelocity& velocity) noexcept {
  const double speed = std::max(size.fastest_hip(velocity), kMinSpeed * size.speed);
  // A swing foot travels speed * period in the swing time, with the peak kPeakSpeed times the mean:
  //   kPeakSpeed * speed * (stance + swing) / swing - speed <= swing_speed
  const double swing_speed = gains.gait_swing_speed * size.height * size.corner_speed;
  const double ratio = std::max((swing_speed / speed + 1.0) / kPeakSpeed - 1.0, kMinStanceRatio);
  GaitTiming timing;
  timing.duty = std::min(gains.gait_duty, ratio / (1.0 + ratio));
  timing.period = std::min(gains.gait_period * size.time,
                           gains.gait_stance_travel * size.height / speed / timing.duty);
  return timing;
}

}  // namespace surefoot
