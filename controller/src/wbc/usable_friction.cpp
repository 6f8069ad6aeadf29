// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/usable_friction.hpp"

#include <algorithm>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

constexpr double kCalm = 0.7;   // of the friction, away from the edge
constexpr double kAhead = 0.1;  // [s] that a push is expected to last
constexpr double kEdge = 0.06;  // [m] inside the edge, where more is used

}  // namespace

Eigen::Vector4d usable_friction(const Dynamics& dynamics, const RobotState& state,
                                const Reference& reference, double mass) noexcept {
  const Vector3 gained = kAhead / mass * state.f_outside;
  const double margin = capture_margin(dynamics, reference, gained) / kEdge;
  const double calm = std::clamp(margin, 0.0, 1.0);
  return (1.0 - calm * (1.0 - kCalm)) * state.friction;
}

}  // namespace surefoot
