// SPDX-License-Identifier: BSD-3-Clause
#include "reference/usable_friction.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

constexpr double kCalm = 0.7;   // of the friction, away from the edge
constexpr double kAhead = 0.1;  // [s] that a push is expected to last
// [m] inside the edge, where more is used. No gain: how hard feet are held down, which
// gains.edge_margin is for, does not change what the ground is trusted with.
constexpr double kEdge = 0.06;

}  // namespace

Eigen::Vector4d usable_friction(const Dynamics& dynamics, const RobotState& state,
                                const Reference& reference, double mass) noexcept {
  const Vector3 gained = kAhead / mass * state.f_outside;
  // A push that ends reads as one against it for a moment: that is no reason to brake less.
  const double margin =
      std::min(capture_margin(dynamics, reference), capture_margin(dynamics, reference, gained));
  if (!std::isfinite(margin)) return state.friction;  // two feet are always near their edge
  const double calm = std::clamp(margin / kEdge, 0.0, 1.0);
  return state.friction.cwiseMin(1.0 - calm * (1.0 - kCalm));
}

}  // namespace surefoot
