// SPDX-License-Identifier: BSD-3-Clause
#include "reference/usable_friction.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// Share of RobotConfig::friction that a foot may use while the capture point is kEdgeDistance or
// more inside. Measured: with 1, a push of half the push limit made feet slide by centimetres on
// floors with friction 0.5 and 0.6 (git 19c79ff). If smaller: near the edge a push needs more
// friction before the share has risen.
constexpr double kNominalShare = 0.7;
// [s] Assumed remaining duration of a push: the duration of the pushes of `surefoot assess`.
constexpr double kPushTime = 0.1;
// [1/s] Rate at which the share falls. Derived: from 1 to kNominalShare in 0.1 s. An immediate fall
// made the torques jump at the end of a push (git 326d016).
constexpr double kDecayRate = 3.0;
// [m] Capture margin below which the share exceeds kNominalShare. Chosen: the default of the gain
// edge_margin. The gain itself tunes the hold-down of the feet, so it must not change the friction.
constexpr double kEdgeDistance = 0.06;

double required_share(const Dynamics& dynamics, const RobotState& state, const Reference& reference,
                      double mass) noexcept {
  const Vector3 dv_com = kPushTime / mass * state.f_external;
  // When a push ends, the estimate briefly shows an opposite push. This error alone would give too
  // large a margin, and so too small a share for braking. The smaller of the two margins avoids
  // this.
  const double margin =
      std::min(capture_margin(dynamics, reference), capture_margin(dynamics, reference, dv_com));
  if (!std::isfinite(margin)) return 1.0;  // on two feet the robot needs all friction
  return 1.0 - std::clamp(margin / kEdgeDistance, 0.0, 1.0) * (1.0 - kNominalShare);
}

}  // namespace

Eigen::Vector4d UsableFriction::update(const Dynamics& dynamics, const RobotState& state,
                                       const Reference& reference, double mass,
                                       double dt) noexcept {
  share_ = std::max(required_share(dynamics, state, reference, mass), share_ - kDecayRate * dt);
  return state.friction.cwiseMin(share_);
}

}  // namespace surefoot
