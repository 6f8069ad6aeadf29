// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/gait_size.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/walk_velocity.hpp"

namespace surefoot {

/// Return the factor, 0 .. 1, on a commanded velocity that keeps the power peaks within a limit.
/// Real-time: yes.
///
/// The power peaks of a trot are about walk_power_rest + walk_power_rise u^3, in units of
/// m g sqrt(g h), where u is the speed of the fastest hip in units of sqrt(g h).
/// @param power_limit [m g sqrt(g h)]; infinity: no limit
double power_factor(const Gains& gains, const GaitSize& size, double power_limit,
                    const WalkVelocity& velocity) noexcept;

}  // namespace surefoot
