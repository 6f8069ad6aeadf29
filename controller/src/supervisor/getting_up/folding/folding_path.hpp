// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// [rad] Magnitude of the calf angle of a leg that is stretched or backs out; 0 is a straight knee.
/// Chosen inside the ranges of all calves: the ranges begin at 0.6 .. 0.92 and end at 2.6 .. 2.73.
/// Far from a folded calf, and far from a straight knee, which is singular.
constexpr double kStretchedCalf = 1.2;

/// Options of folding_target().
struct FoldingMode {
  /// true: the knee-back and stretch motions may be used; false: only the sweep.
  bool allow_detours = true;
  bool rolled = false;  ///< true if the body has rolled over its legs in this folding
};

/// Compute the next target of one leg of a lying robot, on its path to RisePlan::folded.
///
/// The path uses three motions.
///
/// Sweep: while the knee is below the hip, the hip is turned outward, so that the leg passes beside
/// the body. Once the knee is up, the hip is straight, because otherwise the knees of two legs
/// would meet above the body. While the knee points forward the hip is straight too: the foot is
/// then up, and an outward hip would put the foot on the body.
///
/// Knee back: before the knee goes up, the thigh waits in a position that points back along the
/// body, until the hip is straight. Otherwise the knee would jam against the edge of the body.
///
/// Stretch: a leg that is drawn in under the body and points ahead is first stretched ahead along
/// the body, if the range of its thigh allows this. The hip turns outward only when the leg is
/// stretched: the hip of a bent leg would lift this side of the body and roll the body. After a
/// roll of the body, every drawn-in leg is stretched, ahead or behind.
/// @param q measured angles of hip, thigh, calf [rad]
/// @param thigh_reference present reference of the thigh [rad]
/// @return target angles of hip, thigh, calf [rad]. Real-time: yes.
Vector3 folding_target(const RisePlan& plan, int leg, const Vector3& q, double thigh_reference,
                       FoldingMode mode) noexcept;

}  // namespace surefoot
