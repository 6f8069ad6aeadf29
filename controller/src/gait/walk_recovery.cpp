// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_recovery.hpp"

namespace surefoot {

namespace {

// [h] Distance of the capture point from the planned one above which a walk trots: 4 cm at
// h = 0.3 m. Chosen of 0.14, 0.2 and 0.3: with 0.14 a pushed go1 fell least.
constexpr double kTrotDistance = 0.14;
// [h] Distance below which the robot is calm. It walks again after a period of the trot. Chosen
// smaller than kTrotDistance, as hysteresis; other values were not tried.
constexpr double kCalmDistance = 0.1;

}  // namespace

bool WalkRecovery::update(const HorizontalMotion& measured, const HorizontalMotion& planned,
                          bool walks, double period, double dt) noexcept {
  const double distance =
      (measured.p_com - planned.p_com + size_.time * (measured.v_com - planned.v_com)).norm() /
      size_.height;
  calm_time_ = distance > kCalmDistance ? 0.0 : calm_time_ + dt;
  trots_ |= walks && distance > kTrotDistance;
  trots_ = trots_ && calm_time_ < period;
  return trots_;
}

}  // namespace surefoot
