// SPDX-License-Identifier: BSD-3-Clause
#include "reference/usable_friction.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

constexpr double kNominalShare = 0.7;  // of the friction, away from the edge
constexpr double kPushTime = 0.1;      // [s] that a push is expected to last
constexpr double kDecayRate = 3.0;     // [1/s] how fast the share falls
// [m] inside the edge, where more is used. No gain: how hard feet are held down, which
// gains.edge_margin is for, does not change what the ground is trusted with.
constexpr double kEdgeDistance = 0.06;

double required_share(const Dynamics& dynamics, const RobotState& state, const Reference& reference,
                      double mass) noexcept {
  const Vector3 dv_com = kPushTime / mass * state.f_external;
  // A push that ends reads as one against it for a moment: that is no reason to brake less.
  const double margin =
      std::min(capture_margin(dynamics, reference), capture_margin(dynamics, reference, dv_com));
  if (!std::isfinite(margin)) return 1.0;  // two feet are always near their edge
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
