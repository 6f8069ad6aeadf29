// SPDX-License-Identifier: BSD-3-Clause
#include "reference/usable_friction.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

constexpr double kNominalShare = 0.7;  // share of the friction away from the edge
constexpr double kPushTime = 0.1;      // [s] assumed remaining duration of a push
constexpr double kDecayRate = 3.0;     // [1/s] rate at which the share falls
// [m] Capture margin below which more friction is used. It is a constant and not gains.edge_margin:
// that gain tunes the hold-down of the feet, which must not change the reserve of friction.
constexpr double kEdgeDistance = 0.06;

double required_share(const Dynamics& dynamics, const RobotState& state, const Reference& reference,
                      double mass) noexcept {
  const Vector3 dv_com = kPushTime / mass * state.f_external;
  // When a push ends, the estimate briefly shows an opposite push. The smaller margin is used, so
  // that this does not reduce the friction for braking.
  const double margin =
      std::min(capture_margin(dynamics, reference), capture_margin(dynamics, reference, dv_com));
  if (!std::isfinite(margin)) return 1.0;  // on two feet all friction is needed
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
