// SPDX-License-Identifier: BSD-3-Clause
#include "reference/usable_friction.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

constexpr double kCalm = 0.7;      // of the friction, away from the edge
constexpr double kAhead = 0.1;     // [s] that a push is expected to last
constexpr double kTakeBack = 3.0;  // [1/s] how fast the share falls
// [m] inside the edge, where more is used. No gain: how hard feet are held down, which
// gains.edge_margin is for, does not change what the ground is trusted with.
constexpr double kEdge = 0.06;

double needed(const Dynamics& dynamics, const RobotState& state, const Reference& reference,
              double mass) noexcept {
  const Vector3 gained = kAhead / mass * state.f_outside;
  // A push that ends reads as one against it for a moment: that is no reason to brake less.
  const double margin =
      std::min(capture_margin(dynamics, reference), capture_margin(dynamics, reference, gained));
  if (!std::isfinite(margin)) return 1.0;  // two feet are always near their edge
  return 1.0 - std::clamp(margin / kEdge, 0.0, 1.0) * (1.0 - kCalm);
}

}  // namespace

Eigen::Vector4d UsableFriction::update(const Dynamics& dynamics, const RobotState& state,
                                       const Reference& reference, double mass,
                                       double dt) noexcept {
  share_ = std::max(needed(dynamics, state, reference, mass), share_ - kTakeBack * dt);
  return state.friction.cwiseMin(share_);
}

}  // namespace surefoot
