// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"
#include "gait/gait_clock.hpp"

namespace surefoot {

/// Return the factor, 0.5 .. 1, on the period that keeps the capture point within reach at
/// touchdown. It is 1 unless exactly two feet are in stance. Real-time: yes.
///
/// With two feet in stance the zero-moment point is on the line between them. Let d be the
/// distance, normal to this line, of the capture point from its planned place. It grows to
/// d exp(t sqrt(g/h)) in the time t. At touchdown it must not exceed the reach of a step, so
///   t <= sqrt(h/g) ln(reach / d).
/// Source: Khadiv, Herzog, Moosavian, Righetti 2016, "Step timing adjustment: a step toward
/// generating robust gaits".
/// @param timing times of the gait without this factor
double swing_time_factor(const GaitSize& size, const GaitClock& clock, const GaitTiming& timing,
                         const FeetMatrix& p_world_feet, const HorizontalMotion& measured,
                         const BodyTrajectory& body) noexcept;

}  // namespace surefoot
