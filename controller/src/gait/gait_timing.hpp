// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/gait_clock.hpp"
#include "gait/gait_size.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Compute period and duty of a trot at a velocity. Real-time: yes.
///
/// With speed, two things reach their limits. Over a standing foot the body moves by speed times
/// stance time; beyond the gain gait_stance_travel the leg would have to stretch too far, so the
/// period shortens. A swing foot must get ahead of the body in the swing time; beyond the gain
/// gait_swing_speed the motors could not move the leg, so the swing takes a larger share of the
/// period. A duty below 0.5 makes a flying trot: both pairs are in the air at times.
GaitTiming trot_timing(const Gains& gains, const GaitSize& size,
                       const WalkVelocity& velocity) noexcept;

}  // namespace surefoot
