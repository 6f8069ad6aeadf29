// SPDX-License-Identifier: BSD-3-Clause
#include "reference/stand_reference.hpp"

#include <algorithm>

#include "surefoot/stage_clock.hpp"

namespace surefoot {

namespace {

constexpr double kAirTime = 0.2;    // [s] how slowly legs that hang in the air come to their pose
constexpr double kHeld = 0.8;       // share in the air from which on a robot is carried, not thrown
constexpr double kAirReach = 0.15;  // of the standing height that they reach further down

}  // namespace

void StandReference::latch(const Dynamics& dynamics, const Eigen::VectorXd& q) noexcept {
  rolling_.reset();
  steps_.reset();
  support_.latch(contact_points(dynamics));
  const Matrix3 R = support_.R_world_support().transpose();
  const LatchedPose pose{R * (dynamics.p_world_base() - support_.origin()),
                         Quaternion(Matrix3(R * dynamics.R_world_base()))};
  motion_.latch(pose, R * (dynamics.p_world_com() - support_.origin()), q);
}

const Reference& StandReference::update(const Gains& gains, const Dynamics& dynamics,
                                        const Eigen::Vector4d& believed, double dt) noexcept {
  const StageScope stage(Stage::kReference);
  Eigen::Vector4d contact = believed;
  if (three_.lost() != ThreeFeet::kNone) contact[three_.lost()] = 0.0;
  rolling_.update(dynamics, support_.normal(), contact, dt);
  const FeetMatrix p = contact_points(dynamics) - rolling_.way();
  FeetMatrix seen = p;
  Eigen::Vector4d standing = contact;
  steps_.hide_swinging(support_, seen, standing);
  support_.update(seen, standing, dt);
  if (three_.lost() == ThreeFeet::kNone && airborne_ < kHeld) {
    steps_.update(gains, dynamics, p, contact, support_, dt);
  } else {
    steps_.stop(dt);
  }
  const Matrix3& R = support_.R_world_support();
  motion_.step(gains, support_.places(), -R.row(2).transpose(), dt);
  three_.step(support_.places(), motion_.p_com(), dt);
  judge_airborne(contact, dt);
  Vector3 place = motion_.p_base();
  place.z() *= 1.0 + kAirReach;  // a landing needs way to brake in
  support_.carry(dynamics.p_world_base(), place, airborne_);

  reference_.p_com = support_.origin() + R * (motion_.p_com() + three_.lean());
  reference_.v_com = R * motion_.v_com();
  reference_.p_base = support_.origin() + R * motion_.p_base();
  reference_.R_world_base = Quaternion(R) * motion_.R_base();
  reference_.w_world_base = R * motion_.w_base();
  reference_.ground_normal = support_.normal();
  for (int leg = 0; leg < kLegs; ++leg) {
    reference_.feet[leg].p_world = support_.origin() + R * support_.places().col(leg) +
                                   steps_.way().col(leg) + rolling_.way().col(leg);
    reference_.feet[leg].stance = !steps_.lifts(leg);
  }
  if (three_.lost() != ThreeFeet::kNone) leave(three_.lost(), dynamics);
  reference_.alpha_world_base = R * motion_.alpha_base();
  return reference_;
}

// A leg that cannot follow must not be expected to: what its foot was accelerated by would be
// counted on to push the body back.
void StandReference::leave(int leg, const Dynamics& dynamics) noexcept {
  FootReference& foot = reference_.feet[leg];
  foot.stance = false;
  foot.load = 0.0;
  foot.p_world = dynamics.legs()[leg].p_world_contact;
  foot.v_world = dynamics.legs()[leg].v_world_contact;
}

// Slowly off the ground, for feet that hung behind are not to be thrown; at once back on it.
void StandReference::judge_airborne(const Eigen::Vector4d& contact, double dt) noexcept {
  const double in_air = std::clamp(1.0 - contact.sum(), 0.0, 1.0);
  const double slowly = airborne_ + dt / (dt + kAirTime) * (in_air - airborne_);
  airborne_ = std::min(in_air, slowly);
}

}  // namespace surefoot
