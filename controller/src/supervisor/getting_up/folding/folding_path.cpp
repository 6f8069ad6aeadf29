// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/folding/folding_path.hpp"

#include <cmath>

#include "supervisor/common/smoothstep.hpp"

namespace surefoot {

namespace {

// The angles are chosen by hand for the shape of Unitree's legs, with poses from which legs failed
// to fold. Measured with these values (benchmarks/get_up.py): 1000 of 1000 dropped robots stand,
// 250 of each model. Tests: test_leg_folding.cpp. Thigh angles are positive in the folding
// direction, hip angles are positive inward. As the thigh folds, its angle rises through these
// stages: the leg points ahead, the knee is below the hip, the knee points back, the knee is up.
//
constexpr double kHipInward = 0.5;        // [rad] hip angle above which a leg is under the body
constexpr double kThighAhead = -0.3;      // [rad] thigh angle below which a leg points ahead
constexpr double kHipInwardRolled = 0.4;  // [rad] kHipInward after the body has rolled
// [rad] A leg with a smaller thigh angle is stretched ahead, any other leg is stretched behind.
constexpr double kStretchAheadLimit = 0.8;
// [rad] A leg can be stretched ahead only if the forward limit of its thigh is below this angle.
constexpr double kMinStretchReach = -0.8;
// [rad] During the stretch motion, the hip turns outward once the errors of thigh and calf are
// smaller than this angle.
constexpr double kStretchTolerance = 0.3;
// [rad] Sweep: the hip turns outward between the first two thigh angles, and back between the last
// two. From kKneeUp on, the knee is up and the hip is straight.
constexpr double kKneeOutwardStart = -0.8;
constexpr double kKneeOutwardFull = 0.2;
constexpr double kKneeOutwardEnd = 1.3;
constexpr double kKneeUp = 2.2;
// [rad] Thigh angle at which the thigh points back along the body, in the stretch and knee-back
// motions.
constexpr double kKneeBack = 1.9;
// [rad] Knee-back motion: the thigh stays at kKneeBack while the error of the hip is larger than
// this angle.
constexpr double kHipTolerance = 0.2;

// Return the thigh angle x [rad], with its sign changed if necessary so that it is positive in the
// folding direction.
double folding_angle(const RisePlan& plan, int thigh, double x) noexcept {
  return std::copysign(1.0, plan.folded[thigh]) * x;
}

// Return the limit of the thigh [rad] at the end opposite to the folding direction.
double forward_limit(const RisePlan& plan, int thigh) noexcept {
  return plan.folded[thigh] > 0.0 ? plan.lower[thigh] : plan.upper[thigh];
}

// Return whether a leg must be stretched before it folds, see folding_target().
bool must_stretch(const RisePlan& plan, int leg, const Vector3& q, bool rolled) noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  const double inward = -std::copysign(1.0, plan.hip_outward_limit[hip]) * q[0];
  const double thigh_angle = folding_angle(plan, thigh, q[1]);
  const bool can_reach = folding_angle(plan, thigh, forward_limit(plan, thigh)) < kMinStretchReach;
  if (thigh_angle < kThighAhead && inward > kHipInward) return can_reach;
  return rolled && inward > kHipInwardRolled && (thigh_angle >= kStretchAheadLimit || can_reach);
}

Vector3 stretch_target(const RisePlan& plan, int leg, const Vector3& q) noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  const bool ahead = folding_angle(plan, thigh, q[1]) < kStretchAheadLimit;
  Vector3 target = plan.folded.segment<kLegJoints>(hip);
  target[1] = ahead ? forward_limit(plan, thigh) : std::copysign(kKneeBack, target[1]);
  target[2] = std::copysign(kStretchedCalf, target[2]);
  const bool is_stretched = (target - q).tail<2>().cwiseAbs().maxCoeff() < kStretchTolerance;
  target[0] = is_stretched ? plan.hip_outward[hip] : q[0];
  return target;
}

}  // namespace

Vector3 folding_target(const RisePlan& plan, int leg, const Vector3& q, double thigh_reference,
                       FoldingMode mode) noexcept {
  if (mode.allow_detours && must_stretch(plan, leg, q, mode.rolled))
    return stretch_target(plan, leg, q);
  const int hip = kLegJoints * leg, thigh = hip + 1;
  Vector3 target = plan.folded.segment<kLegJoints>(hip);
  const double thigh_angle = folding_angle(plan, thigh, q[1]);
  const double thigh_goal = std::abs(folding_angle(plan, thigh, thigh_reference));
  const double below_hip_share =
      smoothstep((thigh_angle - kKneeOutwardStart) / (kKneeOutwardFull - kKneeOutwardStart));
  const double beside_body_share =
      1.0 - smoothstep((thigh_goal - kKneeOutwardEnd) / (kKneeUp - kKneeOutwardEnd));
  target[0] += plan.hip_outward[hip] * below_hip_share * beside_body_share;
  const bool hip_not_straight =
      thigh_goal > kKneeOutwardEnd && std::abs(target[0] - q[0]) > kHipTolerance;
  if (hip_not_straight && mode.allow_detours) target[1] = std::copysign(kKneeBack, target[1]);
  return target;
}

}  // namespace surefoot
