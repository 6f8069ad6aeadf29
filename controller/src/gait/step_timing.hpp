// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"
#include "gait/gait_clock.hpp"

namespace surefoot {

/// Compute by what factor the time that is left of a swing must become shorter, at most 1, so that
/// the capture point is still within reach at touchdown. Real-time: yes.
///
/// Two feet in stance can press on the line between them, and nowhere beside it. A capture point
/// at the distance d from where the trajectory has it, across this line, moves away with
/// d exp(t sqrt(g/h)). Its distance at touchdown must not exceed the reach of a step, so
///   t <= sqrt(h/g) ln(reach / d).
/// Source: Khadiv, Herzog, Moosavian, Righetti 2016, "Step timing adjustment: a step toward
/// generating robust gaits".
/// @param timing times of the gait without this factor
double swing_time_factor(const GaitSize& size, const GaitClock& clock, const GaitTiming& timing,
                         const FeetMatrix& p_world_feet, const HorizontalMotion& measured,
                         const BodyTrajectory& body) noexcept;

}  // namespace surefoot
