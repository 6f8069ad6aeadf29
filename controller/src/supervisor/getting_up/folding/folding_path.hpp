// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// [rad] calf of a leg that is stretched or backs out. Chosen: inside the calves' ranges (0.6 ..
/// 0.9 to 2.6 .. 2.8 rad), far from folded, and bent enough to be regular.
constexpr double kStretchedCalf = 1.2;

/// Options of folding_target().
struct FoldingMode {
  bool allow_detours = true;  ///< use stretching and the turned-back knee, not only the sweep
  bool rolled = false;        ///< the body has rolled over legs on the usual path
};

/// Compute the next target of one leg of a lying robot on its path to RisePlan::folded.
///
/// Sweep: while the knee is below the hip, the hip is turned outward, so that the leg passes beside
/// the body. Once the knee is up the hip is straight, else the knees of a pair would meet over the
/// back. The hip is also straight while the knee points forward: the foot is up then, and an
/// outward leg would put it on the back.
///
/// Knee over the body: the thigh stays turned back until the hip is straight, else the knee jams
/// against the edge of the body.
///
/// Stretch: a leg drawn in under the body that points ahead is first stretched ahead along the body
/// until its hip is half open, if its thigh reaches that far. Bent, it would lift its side and roll
/// the body as the hip opens. After a roll every drawn-in leg is stretched, ahead or behind.
/// @param q measured hip, thigh, calf [rad] @param thigh_reference present reference [rad]
/// @return hip, thigh, calf [rad]. Real-time: yes.
Vector3 folding_target(const RisePlan& plan, int leg, const Vector3& q, double thigh_reference,
                       FoldingMode mode) noexcept;

}  // namespace surefoot
