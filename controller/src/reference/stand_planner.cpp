// SPDX-License-Identifier: BSD-3-Clause
#include "reference/stand_planner.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// The constants are chosen. Tests: tests/closed_loop/test_external_lifts.py,
// test_stand_planner.cpp.
constexpr double kAirborneTime = 0.2;  // [s] time constant of airborne_share_
// Additional extension of airborne legs, as a share of the standing height. If smaller: the joints
// have too little range left to brake a landing. If larger: the legs are nearly straight.
constexpr double kAirborneExtension = 0.15;

// Number of calls that latch the pose. Chosen: the second and the third latch correct the contact
// points. Two corrections suffice, because the contact points depend on the ground normal only
// through the radius of the soles.
constexpr int kPoseLatches = 3;

}  // namespace

void StandPlanner::reset() noexcept {
  motion_.reset();
  walking_ = false;
  latch_again();
}

void StandPlanner::latch_again() noexcept {
  three_leg_stance_.reset();
  airborne_share_ = 0.0;
  pose_latches_ = 0;
}

bool StandPlanner::plan(const PlannerInput& input, Reference& reference) noexcept {
  // The contact points depend on the ground normal, and the ground normal is computed from the
  // contact points. The pose is latched several times, so that both converge.
  if (pose_latches_ < kPoseLatches) {
    latch(input);
    ++pose_latches_;
  }
  Eigen::Vector4d contact = input.state.contact;
  if (input.lost_leg >= 0) contact[input.lost_leg] = 0.0;
  update_feet(input, contact);
  const Matrix3& R = support_.R_world_support();  // from support to world axes
  motion_.update(input.gains, support_.nominal_feet(), -R.row(2).transpose(), input.dt);
  three_leg_stance_.update(input.lost_leg, support_.nominal_feet(), motion_.p_com(), input.dt);
  update_airborne_share(contact, input.dt);
  Vector3 p_base = motion_.p_base();
  // In the air, extend the legs, so that the joints have more range to brake a landing. For this,
  // follow_body() gets a larger height of the base above the support frame. It then places the
  // frame lower, and the desired feet, which are fixed in the frame, move down with it.
  p_base.z() *= 1.0 + kAirborneExtension;
  support_.follow_body(input.dynamics.p_world_base(), p_base, airborne_share_);
  write(reference);
  return true;
}

void StandPlanner::latch(const PlannerInput& input) noexcept {
  foot_rolling_.reset();
  support_.latch(input.p_feet);
  const Matrix3 R = support_.R_world_support().transpose();  // from world to support axes
  const LatchedPose pose{R * (input.dynamics.p_world_base() - support_.origin()),
                         Quaternion(Matrix3(R * input.R_world_base))};
  const Vector3 p_com = R * (input.p_com - support_.origin());
  motion_.set_walking(false);
  if (walking_) {
    motion_.latch_moved(motion_.origin_of(pose), p_com, input.state.q);
  } else {
    motion_.latch(pose, p_com, input.state.q);
  }
}

void StandPlanner::move_while_walking(const PlannerInput& input, const FeetMatrix& p_feet,
                                      const Vector3& p_base) noexcept {
  // The support frame of the nominal stance: the feet are at z = 0, the base is level.
  const Vector3 p_com = -p_feet.row(2).mean() * Vector3::UnitZ();
  if (pose_latches_ > 0 || !walking_) {
    motion_.latch_moved({p_com + p_base, Quaternion::Identity()}, p_com, input.state.q);
    motion_.set_walking(true);
    walking_ = true;
    pose_latches_ = 0;
  }
  const Vector3 gravity = -(motion_.R_base() * input.R_world_base.row(2).transpose());
  motion_.update(input.gains, p_feet.colwise() + p_com, gravity, input.dt);
}

// Update the rolling of the feet and the support frame.
void StandPlanner::update_feet(const PlannerInput& input, const Eigen::Vector4d& contact) noexcept {
  foot_rolling_.update(input.dynamics, support_.normal(), contact, input.dt);
  support_.update(input.p_feet - foot_rolling_.displacement(), contact, input.dt);
}

void StandPlanner::write(Reference& reference) const noexcept {
  const Matrix3& R = support_.R_world_support();
  reference.p_com = support_.origin() + R * (motion_.p_com() + three_leg_stance_.com_offset());
  reference.v_com = R * motion_.v_com();
  reference.p_base = support_.origin() + R * motion_.p_base();
  reference.R_world_base = Quaternion(R) * motion_.R_base();
  reference.w_world_base = R * motion_.w_base();
  reference.alpha_world_base = R * motion_.alpha_base();
  reference.ground_normal = support_.normal();
  for (int leg = 0; leg < kLegs; ++leg) {
    reference.feet[leg].p_world = support_.origin() + R * support_.nominal_feet().col(leg) +
                                  foot_rolling_.displacement().col(leg);
    reference.feet[leg].stance = true;
  }
}

// Update the airborne share. The share is zero while the sum of the contact confidences is at least
// 1. It falls at once on contact but rises slowly: a fast rise would move the desired feet away
// from the real feet, and would accelerate the legs abruptly.
void StandPlanner::update_airborne_share(const Eigen::Vector4d& contact, double dt) noexcept {
  const double in_air = std::clamp(1.0 - contact.sum(), 0.0, 1.0);
  const double filtered = airborne_share_ + dt / (dt + kAirborneTime) * (in_air - airborne_share_);
  airborne_share_ = std::min(in_air, filtered);
}

}  // namespace surefoot
