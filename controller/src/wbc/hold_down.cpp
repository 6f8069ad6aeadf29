// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/hold_down.hpp"

#include <algorithm>

#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {
constexpr double kFreedom = 3.0;  // [g] more that may be asked downwards away from the edge
}

double edge_fade(const Gains& gains, const Dynamics& dynamics,
                 const Reference& reference) noexcept {
  const double margin = capture_margin(dynamics, reference) / gains.edge_margin;
  return std::clamp(margin, 0.0, 1.0);
}

double least_lift(const Gains& gains, double fade) noexcept {
  return (gains.edge_load - 1.0 - kFreedom * fade) * kGravity;
}

Eigen::Vector4d hold_down_forces(const Gains& gains, double weight, double fade,
                                 const Eigen::Vector4d& contact,
                                 const Reference& reference) noexcept {
  Eigen::Vector4d forces;
  for (int leg = 0; leg < kLegs; ++leg) {
    const FootReference& foot = reference.feet[leg];
    const double load = foot.stance ? std::clamp(foot.load, 0.0, 1.0) : 0.0;
    const double belief = std::clamp(contact[leg], 0.0, 1.0);
    forces[leg] = gains.hold_down * weight * fade * load * belief;
  }
  return forces;
}

}  // namespace surefoot
