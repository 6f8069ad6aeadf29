// SPDX-License-Identifier: BSD-3-Clause
#include "gait/ground_plane.hpp"

#include <Eigen/Geometry>

namespace surefoot {

namespace {

// Smallest vertical part of a normal, cos(60 deg). Chosen: no ground is steeper; feet that are
// nearly in one line can span any plane.
constexpr double kMinVertical = 0.5;

// Return the unit normal of the plane that is parallel to both diagonals; `fallback` if they span
// no ground.
Vector3 normal_of(const FeetMatrix& p, const Vector3& fallback) noexcept {
  const Vector3 n = (p.col(FL_) - p.col(RR_)).cross(p.col(RL_) - p.col(FR_));
  const double norm = n.norm();
  return norm > 1e-4 && n.z() > kMinVertical * norm ? Vector3(n / norm) : fallback;
}

}  // namespace

void GroundPlane::start(const FeetMatrix& p_world_feet) noexcept {
  points_ = p_world_feet;
  normal_ = normal_of(points_, Vector3::UnitZ());
}

void GroundPlane::update(double time_constant, double dt) noexcept {
  normal_ += dt / (dt + time_constant) * (normal_of(points_, normal_) - normal_);
  normal_.normalize();
}

double GroundPlane::height_at(const Eigen::Vector2d& p_world) const noexcept {
  const Vector3 mean = points_.rowwise().mean();
  return mean.z() - normal_.head<2>().dot(p_world - mean.head<2>()) / normal_.z();
}

}  // namespace surefoot
