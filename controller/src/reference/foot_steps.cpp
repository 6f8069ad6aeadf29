// SPDX-License-Identifier: BSD-3-Clause
#include "reference/foot_steps.hpp"

#include <algorithm>
#include <cmath>

#include "reference/capture_margin.hpp"
#include "reference/foot_to_lift.hpp"

namespace surefoot {

namespace {

constexpr double kNear = 0.65;       // share of edge_margin inside the edge from which on feet step
constexpr double kMoving = 0.1;      // [h] that the capture point is ahead of a body to step for
constexpr double kLeft = 0.3;        // belief under which a foot has left the ground
constexpr double kLanded = 0.5;      // and over which it is back
constexpr double kSwing = 0.6;       // [sqrt(h / g)] until it is pressed down; h: of the body
constexpr double kLift = 0.08;       // [h] that it is lifted by
constexpr double kPress = 0.1;       // [h] under the ground that it is pressed to
constexpr double kGain = 0.01;       // [h] that a step must bring the capture point further inside
constexpr double kSpeed = 2.0;       // [sqrt(g h)] of a foot's goal
constexpr double kPlaceTime = 0.05;  // [s] how slowly a place comes to a foot that has stepped
constexpr double kStopTime = 0.2;    // [s] how slowly feet come back that are not to step

double height_over(const FeetMatrix& p_world_feet, const Dynamics& dynamics) noexcept {
  return std::max(dynamics.p_world_com().z() - p_world_feet.row(2).mean(), 0.05);
}

// Its share in the plane of the feet.
Vector3 flat(const Vector3& way, const Vector3& normal) noexcept {
  return way - normal.dot(way) * normal;
}

}  // namespace

void FootSteps::update(const Gains& gains, const Dynamics& dynamics, const FeetMatrix& p_world_feet,
                       const Eigen::Vector4d& contact, SupportFrame& support, double dt) noexcept {
  if (gains.foot_step <= 0.0) return stop(dt);
  const FeetMatrix places = support.p_world_places();
  const FeetMatrix from_place = p_world_feet - places;
  const double height = height_over(p_world_feet, dynamics);
  const Eigen::Vector2d capture = capture_point(dynamics);
  moving_ = (capture - dynamics.p_world_com().head<2>()).norm() > kMoving * height;
  judge_edge(gains, support, places, capture);
  lift_one(p_world_feet, places, contact, capture, kGain * height);
  const double age = dt / std::sqrt(height / kGravity);
  for (int leg = 0; leg < kLegs; ++leg) {
    age_[leg] += age;
    judge_foot(leg, contact[leg], flat(from_place.col(leg), support.normal()));
    if (foot_[leg] != Foot::kStands) {
      swing(leg, from_place.col(leg), support.normal(), height, dt);
    } else {
      const Vector3 come = dt / (dt + kPlaceTime) * way_.col(leg);
      support.move(leg, come);
      way_.col(leg) -= come;
    }
  }
}

void FootSteps::stop(double dt) noexcept {
  foot_.fill(Foot::kStands);
  way_ *= 1.0 - dt / (dt + kStopTime);
}

void FootSteps::hide_swinging(const SupportFrame& support, FeetMatrix& p_world_feet,
                              Eigen::Vector4d& contact) const noexcept {
  const FeetMatrix places = support.p_world_places();
  p_world_feet -= way_;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (foot_[leg] == Foot::kStands) continue;
    p_world_feet.col(leg) = places.col(leg);
    contact[leg] = 0.0;
  }
}

// How near the capture point is to the edge of the places, and the stride that this asks for.
void FootSteps::judge_edge(const Gains& gains, const SupportFrame& support,
                           const FeetMatrix& p_world_places,
                           const Eigen::Vector2d& capture) noexcept {
  const SupportPolygon polygon(p_world_places, {true, true, true, true});
  near_ = 1.0 - std::clamp(polygon.margin(capture) / gains.edge_margin, 0.0, 1.0);
  Vector3 gone = Vector3::Zero();
  gone.head<2>() = capture - support.origin().head<2>();
  stride_ = near_ * flat(gone, support.normal());
  stride_ *= std::min(1.0, gains.foot_step / std::max(stride_.norm(), 1e-6));
}

// A foot that bears steps too if that helps, with the capture point outside; one is unloaded at a
// time.
void FootSteps::lift_one(const FeetMatrix& p_world_feet, const FeetMatrix& p_world_places,
                         const Eigen::Vector4d& contact, const Eigen::Vector2d& capture,
                         double gain) noexcept {
  if (near_ < 1.0) {
    stuck_.fill(false);
    return;
  }
  std::array<bool, kLegs> bearing;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (foot_[leg] == Foot::kLifts) return;
    bearing[leg] = foot_[leg] == Foot::kStands && contact[leg] > kLanded;
  }
  const FeetMatrix goals = p_world_places.colwise() + stride_;
  const int leg = foot_to_lift(p_world_feet, goals, bearing, capture, kSwing, gain);
  if (leg < 0 || stuck_[leg]) return;
  foot_[leg] = Foot::kLifts;
  age_[leg] = 0.0;
}

// Has it left the ground, or landed? Where it landed it stays.
void FootSteps::judge_foot(int leg, double contact, const Vector3& from_place) noexcept {
  Foot& foot = foot_[leg];
  if (foot == Foot::kStands && moving_ && contact < kLeft && near_ > 1.0 - kNear) {
    foot = Foot::kSwings;
    age_[leg] = 0.0;
  } else if (foot == Foot::kLifts && contact < kLeft) {
    foot = Foot::kSwings;
  } else if ((foot == Foot::kSwings && contact > kLanded) ||
             (foot == Foot::kLifts && age_[leg] > kSwing)) {
    stuck_[leg] = foot == Foot::kLifts;
    foot = Foot::kStands;
    way_.col(leg) = from_place;
  }
}

void FootSteps::swing(int leg, const Vector3& from_place, const Vector3& normal, double height,
                      double dt) noexcept {
  Vector3 along = flat(way_.col(leg), normal);
  double up = -kPress * height;
  if (age_[leg] < kSwing) {
    const Vector3 left = stride_ - along;
    const double most = kSpeed * std::sqrt(kGravity * height) * dt;
    along += left * std::min(1.0, most / std::max(left.norm(), most));
    // Lower as it comes to where it is to land; one that still stands goes up.
    const double lift = kLift * height;
    up = lifts(leg) ? lift : std::min(lift, flat(stride_ - from_place, normal).norm() + up);
  }
  way_.col(leg) = along + up * normal;
}

}  // namespace surefoot
