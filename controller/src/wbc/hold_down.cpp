// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/hold_down.hpp"

#include <algorithm>
#include <limits>

#include "reference/support_polygon.hpp"

namespace surefoot {

namespace {
constexpr double kFreedom = 3.0;  // [g] more that may be asked downwards away from the edge
}

double capture_margin(const Dynamics& dynamics, const Reference& reference) noexcept {
  std::array<bool, kLegs> stance;
  for (int leg = 0; leg < kLegs; ++leg) {
    stance[leg] = reference.feet[leg].stance && reference.feet[leg].load > 0.0;
  }
  return capture_margin(dynamics, stance);
}

double capture_margin(const Dynamics& dynamics, const std::array<bool, kLegs>& stance) noexcept {
  FeetMatrix feet;
  for (int leg = 0; leg < kLegs; ++leg) feet.col(leg) = dynamics.legs()[leg].p_world_contact;
  const double height = std::max(dynamics.p_world_com().z() - feet.row(2).mean(), 0.05);
  const double omega = std::sqrt(kGravity / height);
  const Vector3 capture = dynamics.p_world_com() + dynamics.v_world_com() / omega;
  // Fewer than three feet have no edge to be near.
  const SupportPolygon polygon(feet, stance);
  return polygon.exists() ? polygon.margin(capture.head<2>())
                          : std::numeric_limits<double>::infinity();
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
