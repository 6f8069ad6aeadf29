// SPDX-License-Identifier: BSD-3-Clause
#include "reference/usable_friction.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// Share of RobotConfig::friction that a foot may use while the capture point is at least
// kEdgeDistance inside the support polygon. Measured: with 1, a push of half the push limit made
// feet slide by centimetres on floors with friction 0.5 and 0.6 (git 19c79ff). If smaller: at the
// beginning of a push, braking needs more friction than this share allows.
constexpr double kNominalShare = 0.7;
// [s] Assumed remaining duration of a push. Derived: the pushes of `surefoot assess` last as long.
constexpr double kRemainingPushTime = 0.1;
// [1/s] Rate at which the share falls. Derived: from 1 to kNominalShare in 0.1 s. With an immediate
// fall the torques jumped at the end of a push (git 326d016).
constexpr double kDecayRate = 3.0;
// [m] Capture margin below which the share exceeds kNominalShare. Chosen: the default of the gain
// edge_margin. The gain itself is not used, because it tunes the hold-down and must not change the
// friction.
constexpr double kEdgeDistance = 0.06;

// Compute the share of the friction that the capture margin requires, kNominalShare .. 1.
double required_share(const Dynamics& dynamics, const RobotState& state, const Reference& reference,
                      double mass) noexcept {
  const Vector3 dv_com = kRemainingPushTime / mass * state.f_external;
  // When a push ends, the estimate of the external force briefly has the opposite direction. The
  // margin computed with this estimate is then too large, and the share would be too small for
  // braking. So the smaller of the margins without and with the external force counts.
  const double margin =
      std::min(capture_margin(dynamics, reference), capture_margin(dynamics, reference, dv_com));
  if (!std::isfinite(margin)) return 1.0;  // on two feet the robot needs all friction
  return 1.0 - std::clamp(margin / kEdgeDistance, 0.0, 1.0) * (1.0 - kNominalShare);
}

}  // namespace

Eigen::Vector4d UsableFriction::update(const Dynamics& dynamics, const RobotState& state,
                                       const Reference& reference, double mass, double learnt_share,
                                       double dt) noexcept {
  share_ = std::max(required_share(dynamics, state, reference, mass), share_ - kDecayRate * dt);
  return state.friction.cwiseMin(share_ * learnt_share);
}

}  // namespace surefoot
