// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_recovery.hpp"

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// [h] Distance of the capture point from the planned one below which the robot is calm: 3 cm at
// h = 0.3 m. It walks again after a period of the trot. Chosen: one and a half times the error of a
// walk that is not pushed.
constexpr double kCalmDistance = 0.1;

}  // namespace

bool WalkRecovery::update(const Dynamics& dynamics, const StepSchedule& schedule,
                          const HorizontalMotion& measured, const HorizontalMotion& planned,
                          double dt) noexcept {
  std::array<bool, kLegs> stance;
  for (int leg = 0; leg < kLegs; ++leg) stance[leg] = schedule.contacts().in_stance(leg);
  const double distance =
      (measured.p_com - planned.p_com + size_.time * (measured.v_com - planned.v_com)).norm();
  calm_time_ = distance > kCalmDistance * size_.height ? 0.0 : calm_time_ + dt;
  trots_ |= schedule.pattern().walk && capture_margin(dynamics, stance) < 0.0;
  trots_ = trots_ && calm_time_ < schedule.clock().timing().period;
  return trots_;
}

}  // namespace surefoot
