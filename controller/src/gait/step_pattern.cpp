// SPDX-License-Identifier: BSD-3-Clause
#include "gait/step_pattern.hpp"

#include <algorithm>

#include "gait/gait_timing.hpp"

namespace surefoot {

StepPattern suitable_pattern(const StepPattern& present, const Gains& gains, const GaitSize& size,
                             bool walk, const WalkVelocity& command) noexcept {
  StepPattern pattern = present;
  pattern.walk = walk;
  if (walk && size.fastest_hip(command) > 0.0) {
    pattern.order = best_walk_order(present.order, size, command,
                                    gait_timing(pattern, gains, size, command).period,
                                    gains.walk_gait_margin * size.height);
  }
  return pattern;
}

double acceleration_share(const StepPattern& pattern, const Gains& gains, const GaitSize& size,
                          const WalkVelocity& command, const WalkVelocity& velocity) noexcept {
  const bool brakes = size.fastest_hip(command) < size.fastest_hip(velocity);
  if (!pattern.walk || brakes) return 1.0;
  const double period = gait_timing(pattern, gains, size, command).period;
  const double acceleration = gains.walk_gait_speed * size.speed / period;
  return std::min(1.0, acceleration / (gains.walk_acceleration * kGravity));
}

}  // namespace surefoot
