// SPDX-License-Identifier: BSD-3-Clause
#include "reference/three_feet.hpp"

#include <algorithm>

namespace surefoot {

namespace {

constexpr double kInside = 0.5;    // of the triangle's incircle: how far inside its long edge
constexpr double kLeanTime = 0.2;  // [s] how slowly the body goes there

}  // namespace

// The lost foot's neighbours span the edge that the body stands near.
void ThreeFeet::step(const FeetMatrix& places, const Vector3& p_com, double dt) noexcept {
  if (lost_ == kNone) return;
  // FR FL RR RL: the lowest bit is the side, the next the end.
  const Eigen::Vector2d a = places.col(other_side(lost_)).head<2>();
  const Eigen::Vector2d b = places.col(other_end(lost_)).head<2>();
  const Eigen::Vector2d c = places.col(diagonal(lost_)).head<2>();
  const Eigen::Vector2d edge = b - a;
  const double length = std::max(edge.norm(), 1e-6);
  Eigen::Vector2d inward(-edge.y() / length, edge.x() / length);
  if (inward.dot(c - a) < 0.0) inward = -inward;
  const double height = inward.dot(c - a);
  const double inradius = height * length / (length + (c - a).norm() + (c - b).norm());
  const double missing = kInside * inradius - inward.dot(p_com.head<2>() - a);
  const Eigen::Vector2d wanted = std::max(missing, 0.0) * inward;
  lean_.head<2>() += dt / (dt + kLeanTime) * (wanted - lean_.head<2>());
}

}  // namespace surefoot
