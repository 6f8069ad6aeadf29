// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/support_edge.hpp"

#include <algorithm>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {
// [g] At fade = 1 the bound on the downward acceleration is larger by this than at the edge
// (fade = 0). Chosen by `surefoot assess`: with 0.35, a go1 survived 100 % of its push limit in the
// worst of 16 directions. With 3, and with a slower push estimate, it survived 97.5 %.
constexpr double kInsideFallShare = 0.35;
// At fade = 1 the bound on the tilt acceleration is (1 + this) times the bound at the edge
// (fade = 0). Chosen so that the bound has no effect in practice while fade = 1: it is then
// 1000 rad/s^2 for a go1, whose base_kp_tilt requests 820 rad/s^2 per rad.
constexpr double kInsideTurnFactor = 30.0;
// Factor in `slow`. Derived: 1 / (1 - 3/8), so that the tilt bound shrinks only while the body
// rises faster than 3/8 of the gain edge_rise. The share 3/8 is chosen; edge_rise comes from
// benchmarks/weight_search.py.
constexpr double kRiseFade = 1.6;
}  // namespace

double edge_fade(const Gains& gains, const Dynamics& dynamics,
                 const Reference& reference) noexcept {
  const double margin = capture_margin(dynamics, reference) / gains.edge_margin;
  return std::clamp(margin, 0.0, 1.0);
}

void bound_at_edge(const Gains& gains, double fade, double length, double v_up,
                   BodyAcceleration& desired) noexcept {
  const double min_vertical_acceleration =
      (gains.edge_load - 1.0 - kInsideFallShare * fade) * kGravity;
  desired.a.z() = std::max(desired.a.z(), min_vertical_acceleration);
  const double slow = std::clamp(kRiseFade * (1.0 - v_up / gains.edge_rise), 0.0, 1.0);
  const double max_tilt_acceleration =
      slow * (1.0 + kInsideTurnFactor * fade * fade) * kGravity / length;
  const double desired_norm = desired.alpha.head<2>().norm();
  if (desired_norm > max_tilt_acceleration)
    desired.alpha.head<2>() *= max_tilt_acceleration / desired_norm;
}

}  // namespace surefoot
