// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/edge_demand.hpp"

#include <algorithm>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {
constexpr double kFreedom = 0.35;  // [g] more that may be asked downwards away from the edge
constexpr double kTurning = 30.0;  // [g / length] more of tilting back, growing with its square
constexpr double kRising = 1.6;    // from 3/8 of edge_rise on it turns back less
}  // namespace

double edge_fade(const Gains& gains, const Dynamics& dynamics,
                 const Reference& reference) noexcept {
  const double margin = capture_margin(dynamics, reference) / gains.edge_margin;
  return std::clamp(margin, 0.0, 1.0);
}

void bound_at_edge(const Gains& gains, double fade, double length, double v_up,
                   BodyDemand& demand) noexcept {
  const double least_lift = (gains.edge_load - 1.0 - kFreedom * fade) * kGravity;
  demand.a.z() = std::max(demand.a.z(), least_lift);
  const double slow = std::clamp(kRising * (1.0 - v_up / gains.edge_rise), 0.0, 1.0);
  const double most_turning = slow * (1.0 + kTurning * fade * fade) * kGravity / length;
  const double asked = demand.alpha.head<2>().norm();
  if (asked > most_turning) demand.alpha.head<2>() *= most_turning / asked;
}

}  // namespace surefoot
