// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/getting_up/folding/leg_folding.hpp"

#include <algorithm>
#include <cmath>

#include "supervisor/common/tilt.hpp"
#include "supervisor/getting_up/folding/folding_path.hpp"

namespace surefoot {

namespace {

// The constants are chosen by hand. Measured with these values (benchmarks/get_up.py): 1000 of 1000
// dropped robots stand, with at most 93 W at level 1 (100 W). Tests: test_leg_folding.cpp.
//
// [rad/s] Largest speed of a joint reference. Slow, because folding takes power.
constexpr double kSpeed = 1.2;
// [rad/s^2] Acceleration of a joint reference: it reaches kSpeed in 80 ms.
constexpr double kAcceleration = 15.0;
// [1/s] Speed of a joint reference near its target, divided by its distance to the target.
constexpr double kSettlingRate = 4.0;
// [rad] Largest lead of a joint reference over the measured joint angle. Smaller than
// kMaxDeflection of JointImpedance (0.45).
constexpr double kMaxLead = 0.4;
// [rad] Replaces kMaxLead for two legs that may block each other. With a smaller lead, the springs
// of these legs take less power when the legs come free.
constexpr double kInterferenceLead = 0.3;
// [s] Folding time of a leg for which the stretch and knee-back motions are allowed; after this
// time, only the sweep (see folding_target()).
constexpr double kDetourTime = 4.0;
// [s] Time constant with which the references of released legs approach the measured angles, so
// that torques do not jump.
constexpr double kReleaseTime = 0.03;
// [rad] Error below which a reference is at its target.
constexpr double kReferenceTolerance = 0.005;
// [rad] Error below which a joint is at its target. Friction and ground can cause such an error.
constexpr double kJointTolerance = 0.25;
// [rad] A leg that is not folded has caught if none of its joints moves by more than this within
// kCatchTime.
constexpr double kMinMovement = 0.1;
constexpr double kCatchTime = 1.0;    // [s] in this time a leg could move by 1.2 rad
constexpr double kBackOutTime = 1.5;  // [s] duration of backing out: up to 1.8 rad at kSpeed
// [rad] Displacement of the thigh per catch: after n catches, the thigh backs out by n times this.
constexpr double kBackOutStep = 0.6;

}  // namespace

void LegFolding::start(const Vector12& measured, const Vector3& up) noexcept {
  reference_.q = measured;
  reference_.dq.setZero();
  tilt_start_ = tilt_angle(up);
  rollover_.start(up);
  q_start_ = measured;
  next_weighing_ = 0;
  restart(measured, up);
}

FoldingOrder::Leg LegFolding::order_input(int leg, const Vector12& measured) const noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  return {-std::copysign(1.0, plan_.hip_outward_limit[hip]) * measured[hip],
          std::copysign(1.0, plan_.folded[thigh]) * measured[thigh]};
}

void LegFolding::restart(const Vector12& measured, const Vector3& up) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    legs_[leg] = {};
    legs_[leg].q = measured.segment<kLegJoints>(kLegJoints * leg);
  }
  time_ = 0.0;
  done_ = false;
  order_.start(up,
               {order_input(FR_, measured), order_input(FL_, measured), order_input(RR_, measured),
                order_input(RL_, measured)},
               rollover_.rolls() > 0, wait_);
}

// Let the references follow the measured angles. So the springs have little deflection, the motors
// give only damping and gravity torques, and the body sinks to the ground.
void LegFolding::relax_legs(const Vector12& measured, const Vector3& up, double dt) noexcept {
  reference_.q += dt / (dt + kReleaseTime) * (measured - reference_.q);
  reference_.dq.setZero();
  restart(measured, up);
}

bool LegFolding::detect_rollover(const JointReference& held, const Vector3& up,
                                 double dt) noexcept {
  rollover_.update(up, dt);
  if (!rollover_.releases_legs() && !rollover_.rolled_over()) return false;
  reference_ = held;
  return true;
}

bool LegFolding::folded(int leg, const Vector12& measured) const noexcept {
  const int hip = kLegJoints * leg;
  const auto desired = plan_.folded.segment<kLegJoints>(hip);
  const auto max_error = [&](const Vector12& q) {
    return (desired - q.segment<kLegJoints>(hip)).cwiseAbs().maxCoeff();
  };
  return max_error(reference_.q) < kReferenceTolerance && max_error(measured) < kJointTolerance;
}

// Count a catch of a leg that is not folded and does not move, and start to back out.
void LegFolding::detect_catch(int leg, const Vector12& measured, double dt) noexcept {
  Leg& own = legs_[leg];
  if (own.back_out_time > 0.0 || own.rest_time > 0.0) {
    own.back_out_time -= dt;
    own.rest_time -= dt;
    return;
  }
  const int hip = kLegJoints * leg;
  const Vector3 q = measured.segment<kLegJoints>(hip);
  const Vector3 remaining = plan_.folded.segment<kLegJoints>(hip) - q;
  const bool at_target = remaining.cwiseAbs().maxCoeff() < kJointTolerance;
  if (at_target || (q - own.q).cwiseAbs().maxCoeff() > kMinMovement) {
    own.q = q;
    own.still_time = 0.0;
  }
  own.still_time += dt;
  if (own.still_time < kCatchTime) return;
  own.still_time = 0.0;
  ++own.catches;
  // On every second catch, the neighbour on the same side backs out instead, because it may block
  // this leg. If both legs backed out at once, they would push against each other.
  Leg& neighbour = legs_[longitudinal_neighbor(leg)];
  if (own.catches % 2 == 1 || neighbour.back_out_time > 0.0 || neighbour.rest_time > 0.0) {
    own.back_out_time = kBackOutTime;
    return;
  }
  own.interfered = neighbour.interfered = true;
  own.rest_time = kBackOutTime;
  neighbour.q = measured.segment<kLegJoints>(kLegJoints * (longitudinal_neighbor(leg)));
  neighbour.back_out_time = kBackOutTime;
  neighbour.catches = std::max(neighbour.catches, 1);
}

Vector3 LegFolding::target(int leg, const Vector12& measured) const noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  const Leg& own = legs_[leg];
  if (own.rest_time > 0.0) return measured.segment<kLegJoints>(hip);
  if (own.back_out_time > 0.0) {
    Vector3 target = plan_.folded.segment<kLegJoints>(hip);
    const double remaining = target[1] - own.q[1];
    // A thigh that is already at its folded angle backs out against the folding direction.
    const double displacement = std::abs(remaining) < kJointTolerance ? target[1] : remaining;
    const double step = std::copysign(own.catches * kBackOutStep, displacement);
    target[0] = plan_.hip_outward_limit[hip];
    target[1] = std::clamp(own.q[1] - step, plan_.lower[thigh], plan_.upper[thigh]);
    target[2] = std::copysign(kStretchedCalf, target[2]);
    return target;
  }
  return folding_target(plan_, leg, measured.segment<kLegJoints>(hip), reference_.q[thigh],
                        {own.time < kDetourTime, rollover_.rolls() > 0});
}

void LegFolding::step_joint(int joint, double desired, double measured, double dt) noexcept {
  double &q = reference_.q[joint], &dq = reference_.dq[joint];
  const double remaining = desired - q;
  // The speed is reduced from half of the allowed lead on, and is 0 at the allowed lead.
  const double lead = legs_[joint / kLegJoints].interfered ? kInterferenceLead : kMaxLead;
  const double lead_ratio = std::copysign(1.0, remaining) * (q - measured) / lead;
  const double max_speed = kSpeed * std::clamp(2.0 * (1.0 - lead_ratio), 0.0, 1.0);
  const double speed = std::clamp(kSettlingRate * remaining, -max_speed, max_speed);
  dq += std::clamp(speed - dq, -kAcceleration * dt, kAcceleration * dt);
  q += dq * dt;
}

const JointReference& LegFolding::step(const Vector12& measured, const Vector3& up,
                                       double dt) noexcept {
  rollover_.update(up, dt);
  if (rollover_.releases_legs()) {
    relax_legs(measured, up, dt);
    return reference_;
  }
  time_ += dt;
  bool others_folded = true;
  done_ = true;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!order_.waits(leg)) step_leg(leg, measured, dt);
    const bool folded = this->folded(leg, measured);
    others_folded = others_folded && (folded || order_.waits(leg));
    done_ = done_ && folded;
  }
  order_.update(others_folded, dt);
  return reference_;
}

void LegFolding::step_leg(int leg, const Vector12& measured, double dt) noexcept {
  legs_[leg].time += dt;
  detect_catch(leg, measured, dt);
  const Vector3 desired = target(leg, measured);
  for (int i = 0; i < kLegJoints; ++i) {
    const int joint = kLegJoints * leg + i;
    step_joint(joint, desired[i], measured[joint], dt);
  }
}

}  // namespace surefoot
