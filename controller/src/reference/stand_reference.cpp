// SPDX-License-Identifier: BSD-3-Clause
#include "reference/stand_reference.hpp"

#include <algorithm>

#include "surefoot/stage_clock.hpp"

namespace surefoot {

namespace {

// The constants are chosen. Tests: tests/closed_loop/test_external_lifts.py,
// test_stand_reference.cpp.
constexpr double kAirborneTime = 0.2;  // [s] time constant of airborne_share_
// Airborne share above which recovery steps stop. The share reaches this value after 0.32 s in the
// air. If smaller: a fall from 10 cm, which lasts 0.14 s, would stop recovery steps. If larger:
// while a person lifts the robot, recovery steps would press feet down and stretch their legs for
// longer.
constexpr double kLiftedShare = 0.8;
// Additional extension of airborne legs, as a share of the standing height. If smaller: the joints
// have too little range left to brake a landing. If larger: the legs are nearly straight.
constexpr double kAirborneExtension = 0.15;

}  // namespace

void StandReference::latch(const Dynamics& dynamics, const Eigen::VectorXd& q) noexcept {
  foot_rolling_.reset();
  recovery_steps_.reset();
  support_.latch(contact_points(dynamics));
  const Matrix3 R = support_.R_world_support().transpose();  // from world to support axes
  const LatchedPose pose{R * (dynamics.p_world_base() - support_.origin()),
                         Quaternion(Matrix3(R * dynamics.R_world_base()))};
  motion_.latch(pose, R * (dynamics.p_world_com() - support_.origin()), q);
}

const Reference& StandReference::update(const Gains& gains, const Dynamics& dynamics,
                                        const Eigen::Vector4d& contact_confidence,
                                        double dt) noexcept {
  const StageScope stage(Stage::kReference);
  Eigen::Vector4d contact = contact_confidence;
  if (three_leg_stance_.lost_leg() != ThreeLegStance::kNone)
    contact[three_leg_stance_.lost_leg()] = 0.0;
  foot_rolling_.update(dynamics, support_.normal(), contact, dt);
  const FeetMatrix p = contact_points(dynamics) - foot_rolling_.displacement();
  FeetMatrix support_feet = p;
  Eigen::Vector4d support_contact = contact;
  recovery_steps_.exclude_swing_feet(support_, support_feet, support_contact);
  support_.update(support_feet, support_contact, dt);
  if (three_leg_stance_.lost_leg() == ThreeLegStance::kNone && airborne_share_ < kLiftedShare) {
    recovery_steps_.update(gains, dynamics, p, contact, support_, dt);
  } else {
    recovery_steps_.stop(dt);
  }
  const Matrix3& R = support_.R_world_support();  // from support to world axes
  motion_.update(gains, support_.nominal_feet(), -R.row(2).transpose(), dt);
  three_leg_stance_.update(support_.nominal_feet(), motion_.p_com(), dt);
  update_airborne_share(contact, dt);
  Vector3 p_base = motion_.p_base();
  // In the air, extend the legs, so that the joints have more range to brake a landing. For this,
  // follow_body() gets a larger height of the base above the support frame. It then places the
  // frame lower, and the desired feet, which are fixed in the frame, move down with it.
  p_base.z() *= 1.0 + kAirborneExtension;
  support_.follow_body(dynamics.p_world_base(), p_base, airborne_share_);

  reference_.p_com = support_.origin() + R * (motion_.p_com() + three_leg_stance_.com_offset());
  reference_.v_com = R * motion_.v_com();
  reference_.p_base = support_.origin() + R * motion_.p_base();
  reference_.R_world_base = Quaternion(R) * motion_.R_base();
  reference_.w_world_base = R * motion_.w_base();
  reference_.ground_normal = support_.normal();
  for (int leg = 0; leg < kLegs; ++leg) {
    reference_.feet[leg].p_world = support_.origin() + R * support_.nominal_feet().col(leg) +
                                   recovery_steps_.foot_offsets().col(leg) +
                                   foot_rolling_.displacement().col(leg);
    // Only a foot that lifts off must be unloaded. A swing foot keeps stance = true, so that the QP
    // lets it carry load as soon as it lands. Until then its contact confidence limits its load.
    reference_.feet[leg].stance = !recovery_steps_.is_lifting_off(leg);
  }
  if (three_leg_stance_.lost_leg() != ThreeLegStance::kNone)
    release_leg(three_leg_stance_.lost_leg(), dynamics);
  reference_.alpha_world_base = R * motion_.alpha_base();
  return reference_;
}

// Set the reference of a lost leg's foot: no load, and the measured motion as desired motion. With
// any other desired motion the QP would plan to accelerate the lost leg, for example to get a
// reaction force on the trunk. But the leg has no torque, so this force would not exist.
void StandReference::release_leg(int leg, const Dynamics& dynamics) noexcept {
  FootReference& foot = reference_.feet[leg];
  foot.stance = false;
  foot.load = 0.0;
  foot.p_world = dynamics.legs()[leg].p_world_contact;
  foot.v_world = dynamics.legs()[leg].v_world_contact;
}

// Update the airborne share. The share is zero while the sum of the contact confidences is at least
// 1. It falls at once on contact but rises slowly: a fast rise would move the desired feet away
// from the real feet, and would accelerate the legs abruptly.
void StandReference::update_airborne_share(const Eigen::Vector4d& contact, double dt) noexcept {
  const double in_air = std::clamp(1.0 - contact.sum(), 0.0, 1.0);
  const double filtered = airborne_share_ + dt / (dt + kAirborneTime) * (in_air - airborne_share_);
  airborne_share_ = std::min(in_air, filtered);
}

}  // namespace surefoot
