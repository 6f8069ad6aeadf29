// SPDX-License-Identifier: BSD-3-Clause
#include "gait/ground_plane.hpp"

#include <Eigen/Geometry>

namespace surefoot {

namespace {

// Smallest vertical part of a normal, cos(60 deg). Chosen: no ground is steeper; feet that are
// nearly in one line can span any plane.
constexpr double kMinVertical = 0.5;
// [sqrt(h/g)] Time constant of the normal: 0.35 s at h = 0.3 m. Chosen: about a period, so that one
// foot on a step does not tilt the body.
constexpr double kNormalTime = 2.0;
// [sqrt(h/g)] Time constant of the height under the body: 0.17 s at h = 0.3 m. Chosen: about a
// stance, in which the legs lift the body onto a step.
constexpr double kHeightTime = 1.0;

// Return the unit normal of the plane that is parallel to both diagonals; `fallback` if they span
// no ground.
Vector3 normal_of(const FeetMatrix& p, const Vector3& fallback) noexcept {
  const Vector3 n = (p.col(FL_) - p.col(RR_)).cross(p.col(RL_) - p.col(FR_));
  const double norm = n.norm();
  return norm > 1e-4 && n.z() > kMinVertical * norm ? Vector3(n / norm) : fallback;
}

}  // namespace

void GroundPlane::start(const FeetMatrix& p_world_feet, const Eigen::Vector4d& contact,
                        const Vector3& normal, double sink) noexcept {
  sink_ = sink;
  // Numerical: the small share gives a mean when no foot has contact.
  const Eigen::Vector4d weight = contact.array() + 1e-3;
  mean_ = p_world_feet * weight / weight.sum();
  normal_ = normal;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 p = p_world_feet.col(leg);
    points_.col(leg) << p.head<2>(), height_at(p.head<2>());
    points_.col(leg) += contact[leg] * (p - points_.col(leg));
  }
  mean_ = points_.rowwise().mean();
  jump_ = 0.0;
}

void GroundPlane::update(double time, const Eigen::Vector2d& p_world, double sink,
                         double dt) noexcept {
  const double last = height_at(p_world);
  mean_ = points_.rowwise().mean();
  normal_ += dt / (dt + kNormalTime * time) * (normal_of(points_, normal_) - normal_);
  normal_.normalize();
  const double decay = kHeightTime * time / (dt + kHeightTime * time);
  jump_ = decay * (jump_ + height_at(p_world) - last);
  sink_ = sink + decay * (sink_ - sink);
}

double GroundPlane::height_at(const Eigen::Vector2d& p_world) const noexcept {
  return mean_.z() - normal_.head<2>().dot(p_world - mean_.head<2>()) / normal_.z();
}

}  // namespace surefoot
