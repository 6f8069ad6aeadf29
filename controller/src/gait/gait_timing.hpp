// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/gait_clock.hpp"
#include "gait/step_pattern.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Compute the times of a gait at a velocity. Real-time: yes.
///
/// Two limits change the timing at speed. The body moves by speed times stance time over a stance
/// foot; above the gain gait_stance_travel the period is shortened. A swing foot must get ahead of
/// the body; above the gain gait_swing_speed the duty factor is lowered. Below a duty factor of 0.5
/// all feet are in the air at times (flying trot). In a walk it stays at 0.75 or above: three feet
/// are in stance.
GaitTiming gait_timing(const StepPattern& pattern, const Gains& gains, const GaitSize& size,
                       const WalkVelocity& velocity) noexcept;

}  // namespace surefoot
