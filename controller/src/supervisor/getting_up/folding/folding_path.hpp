// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

constexpr double kStretchedCalf = 1.2;  ///< [rad] a leg that is stretched, or backs out

/// How a leg's way is chosen.
struct FoldingMode {
  bool allow_detours =
      true;             ///< is there still time for ways round? Without, only the sweep is left
  bool rolled = false;  ///< has the body rolled over legs that took the usual way?
};

/// Where the joints of one leg of a lying robot are to go next, on their way to RisePlan::folded.
///
/// While a knee is below its hip that hip is turned outward, so that the leg sweeps beside the
/// body; once the knee is up the hip goes straight, or the knees of a pair would meet over the
/// back. So it is while a knee points forward: the foot is then up, and a leg that leans outward
/// would lay it on the back. A knee that leans over the body is turned back until its hip is
/// straight: upright it would wedge itself against the body's edge. A leg that is drawn in under
/// the body and points ahead is stretched out along it until its hip is half open, if its thigh can
/// point so far ahead: bent, it lifts its side of the body as the hip opens, and the body rolls.
/// Where it has rolled, so is any such leg, and one that points behind is stretched behind.
/// @param q measured @param thigh_reference [rad]
/// @return hip, thigh, calf [rad]. Real-time: yes.
Vector3 folding_target(const RisePlan& plan, int leg, const Vector3& q, double thigh_reference,
                       FoldingMode mode) noexcept;

}  // namespace surefoot
