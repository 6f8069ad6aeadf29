// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_power.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot {

double power_factor(const Gains& gains, const GaitSize& size, double power_limit,
                    const WalkVelocity& velocity) noexcept {
  const double speed = size.fastest_hip(velocity) / size.speed;
  const double power = power_limit - gains.walk_power_rest;
  if (speed <= 0.0 || !(power < gains.walk_power_rise * speed * speed * speed)) return 1.0;
  return std::cbrt(std::max(power, 0.0) / gains.walk_power_rise) / speed;
}

}  // namespace surefoot
