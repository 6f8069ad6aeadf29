// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/gait_clock.hpp"
#include "gait/step_pattern.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Compute the times of a gait at a velocity. Real-time: yes.
///
/// Two limits change the timing at speed. Stance: the body moves by speed times stance time past a
/// standing foot; above the gain gait_stance_travel the period shortens. Swing: a foot must get
/// ahead of the body in the swing time; above the gain gait_swing_speed the duty falls. A duty
/// below 0.5 makes a flying trot: both pairs are in the air at times. The duty of a walk stays at
/// 0.75 and above: three feet stand.
GaitTiming gait_timing(const StepPattern& pattern, const Gains& gains, const GaitSize& size,
                       const WalkVelocity& velocity) noexcept;

}  // namespace surefoot
