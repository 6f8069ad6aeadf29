// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/folding_path.hpp"

#include <cmath>

#include "supervisor/smooth.hpp"

namespace surefoot {

namespace {

constexpr double kDrawnIn = 0.5;       // [rad] hip turned inward: the leg is under the body ...
constexpr double kPoints = -0.3;       // [rad] thigh: ... and points ahead
constexpr double kDrawnInAgain = 0.4;  // [rad] the same where the body has rolled ...
constexpr double kAhead = 0.8;         // [rad] thigh: ... up to here the leg is stretched ahead ...
constexpr double kFarAhead = -0.8;  // [rad] ... if it can go so far, else not; further back, behind
constexpr double kStretched = 0.3;  // [rad] thigh and calf: as near, the hip may open
constexpr double kKneeForward = -0.8;  // [rad] thigh: from here the hip is turned outward ...
constexpr double kKneeBelow = 0.2;     // ... until it is wholly here ...
constexpr double kKneeBeside = 1.3;    // ... up to here ...
constexpr double kKneeUp = 2.2;        // ... and from here on it is straight
constexpr double kKneeBack = 1.9;      // [rad] thigh: along the body, behind ...
constexpr double kHipOff = 0.2;        // [rad] where a knee that leans stays until its hip is near

// An angle of the thigh, positive the way that it folds.
double turned_back(const RisePlan& plan, int thigh, double x) noexcept {
  return std::copysign(1.0, plan.folded[thigh]) * x;
}

double forward_end(const RisePlan& plan, int thigh) noexcept {
  return plan.folded[thigh] > 0.0 ? plan.lower[thigh] : plan.upper[thigh];
}

bool is_to_stretch(const RisePlan& plan, int leg, const Vector3& q, bool rolled) noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  const double inward = -std::copysign(1.0, plan.widest[hip]) * q[0];
  const double at = turned_back(plan, thigh, q[1]);
  const bool can = turned_back(plan, thigh, forward_end(plan, thigh)) < kFarAhead;
  if (at < kPoints && inward > kDrawnIn) return can;
  return rolled && inward > kDrawnInAgain && (at >= kAhead || can);
}

Vector3 stretched(const RisePlan& plan, int leg, const Vector3& q) noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  const bool ahead = turned_back(plan, thigh, q[1]) < kAhead;
  Vector3 target = plan.folded.segment<kLegJoints>(hip);
  target[1] = ahead ? forward_end(plan, thigh) : std::copysign(kKneeBack, target[1]);
  target[2] = std::copysign(kOpenCalf, target[2]);
  const bool there = (target - q).tail<2>().cwiseAbs().maxCoeff() < kStretched;
  target[0] = there ? plan.wide[hip] : q[0];
  return target;
}

}  // namespace

Vector3 folding_target(const RisePlan& plan, int leg, const Vector3& q, double to,
                       FoldingTry how) noexcept {
  if (how.gently && is_to_stretch(plan, leg, q, how.rolled)) return stretched(plan, leg, q);
  const int hip = kLegJoints * leg, thigh = hip + 1;
  Vector3 target = plan.folded.segment<kLegJoints>(hip);
  const double at = turned_back(plan, thigh, q[1]);
  const double going = std::abs(turned_back(plan, thigh, to));
  const double below = smooth((at - kKneeForward) / (kKneeBelow - kKneeForward));
  const double beside = 1.0 - smooth((going - kKneeBeside) / (kKneeUp - kKneeBeside));
  target[0] += plan.wide[hip] * below * beside;
  const bool leans = going > kKneeBeside && std::abs(target[0] - q[0]) > kHipOff;
  if (leans && how.gently) target[1] = std::copysign(kKneeBack, target[1]);
  return target;
}

}  // namespace surefoot
