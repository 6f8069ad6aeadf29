// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/hold_down.hpp"

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {

using Vector2 = Eigen::Vector2d;

// Round the robot, counter-clockwise from above.
constexpr int kRound[kLegs] = {FR_, FL_, RL_, RR_};

double cross(const Vector2& a, const Vector2& b) noexcept { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

double capture_margin(const Dynamics& dynamics, const Reference& reference) noexcept {
  std::array<Vector2, kLegs> corner;
  int corners = 0;
  double ground = 0.0;
  for (const int leg : kRound) {
    if (!reference.feet[leg].stance) continue;
    const Vector3& p = dynamics.legs()[leg].p_world_contact;
    corner[corners++] = p.head<2>();
    ground += p.z();
  }
  if (corners < 3) return 0.0;
  const double height = std::max(dynamics.p_world_com().z() - ground / corners, 0.05);
  const double omega = std::sqrt(kGravity / height);
  const Vector2 capture =
      dynamics.p_world_com().head<2>() + dynamics.v_world_com().head<2>() / omega;
  double margin = std::numeric_limits<double>::infinity();
  for (int k = 0; k < corners; ++k) {
    const Vector2 edge = corner[(k + 1) % corners] - corner[k];
    const double length = std::max(edge.norm(), 1e-6);
    margin = std::min(margin, cross(edge, capture - corner[k]) / length);
  }
  return margin;
}

Eigen::Vector4d hold_down_forces(const Gains& gains, double weight, const Dynamics& dynamics,
                                 const Eigen::Vector4d& contact,
                                 const Reference& reference) noexcept {
  const double margin = capture_margin(dynamics, reference) / gains.hold_down_margin;
  const double fade = std::min(std::max(margin, 0.0), 1.0);
  Eigen::Vector4d forces;
  for (int leg = 0; leg < kLegs; ++leg) {
    const FootReference& foot = reference.feet[leg];
    const double load = foot.stance ? std::min(std::max(foot.load, 0.0), 1.0) : 0.0;
    const double belief = std::min(std::max(contact[leg], 0.0), 1.0);
    forces[leg] = gains.hold_down * weight * fade * load * belief;
  }
  return forces;
}

}  // namespace surefoot
