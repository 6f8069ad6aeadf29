// SPDX-License-Identifier: BSD-3-Clause
#include "supervisor/leg_folding.hpp"

#include <algorithm>
#include <cmath>

#include "supervisor/folding_path.hpp"
#include "supervisor/lean.hpp"

namespace surefoot {

namespace {

constexpr double kSpeed = 1.2;          // [rad/s]
constexpr double kAcceleration = 15.0;  // [rad/s^2]
constexpr double kPull = 4.0;           // [1/s] how the reference ends
constexpr double kLead = 0.4;           // [rad] that it may run ahead of its joint
constexpr double kWedgedLead = 0.3;     // [rad] of legs that hold each other: none is to fly
constexpr double kGently = 4.0;         // [s] that ways round are taken
constexpr double kLetGo = 0.03;         // [s] not at once: no step of torque
constexpr double kThere = 0.005;        // [rad] of the reference
constexpr double kNear = 0.25;          // [rad] of the joints: friction and the ground hold them
constexpr double kMoved = 0.1;          // [rad] by which a leg that has not caught moves ...
constexpr double kWait = 1.0;           // [s] ... in this time
constexpr double kBackTime = 1.5;       // [s] that a leg backs out for
constexpr double kBackStep = 0.6;       // [rad] thigh: how far, on the first try

}  // namespace

void LegFolding::start(const Vector12& measured, const Vector3& up) noexcept {
  reference_.q = measured;
  reference_.dq.setZero();
  lean_ = lean(up);
  roll_.start(up);
  first_ = measured;
  next_weighing_ = 0;
  begin(measured, up);
}

FoldingTurns::Leg LegFolding::turn_of(int leg, const Vector12& measured) const noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  return {-std::copysign(1.0, plan_.widest[hip]) * measured[hip],
          std::copysign(1.0, plan_.folded[thigh]) * measured[thigh]};
}

void LegFolding::begin(const Vector12& measured, const Vector3& up) noexcept {
  for (int leg = 0; leg < kLegs; ++leg) {
    legs_[leg] = {};
    legs_[leg].q = measured.segment<kLegJoints>(kLegJoints * leg);
  }
  time_ = 0.0;
  done_ = false;
  turns_.start(up,
               {turn_of(FR_, measured), turn_of(FL_, measured), turn_of(RR_, measured),
                turn_of(RL_, measured)},
               roll_.rolls() > 0, wait_);
}

// Springs that follow their joints: what they trail by damps as the motors do, and that lays the
// body down.
void LegFolding::let_go(const Vector12& measured, const Vector3& up, double dt) noexcept {
  reference_.q += dt / (dt + kLetGo) * (measured - reference_.q);
  reference_.dq.setZero();
  begin(measured, up);
}

bool LegFolding::rolls(const JointReference& at, const Vector3& up, double dt) noexcept {
  roll_.update(up, dt);
  if (!roll_.lets_go() && !roll_.rolls_on()) return false;
  reference_ = at;
  return true;
}

bool LegFolding::folded(int leg, const Vector12& measured) const noexcept {
  const int hip = kLegJoints * leg;
  const auto wanted = plan_.folded.segment<kLegJoints>(hip);
  const auto off = [&](const Vector12& q) {
    return (wanted - q.segment<kLegJoints>(hip)).cwiseAbs().maxCoeff();
  };
  return off(reference_.q) < kThere && off(measured) < kNear;
}

// A leg has caught that neither moves nor is where it is to be.
void LegFolding::watch(int leg, const Vector12& measured, double dt) noexcept {
  Leg& one = legs_[leg];
  if (one.back > 0.0 || one.rest > 0.0) {
    one.back -= dt;
    one.rest -= dt;
    return;
  }
  const int hip = kLegJoints * leg;
  const Vector3 q = measured.segment<kLegJoints>(hip);
  const Vector3 left = plan_.folded.segment<kLegJoints>(hip) - q;
  const bool there = left.cwiseAbs().maxCoeff() < kNear;
  if (there || (q - one.q).cwiseAbs().maxCoeff() > kMoved) {
    one.q = q;
    one.still = 0.0;
  }
  one.still += dt;
  if (one.still < kWait) return;
  one.still = 0.0;
  ++one.tries;
  // Every other time the leg beside it makes room, which may hold it: both at once only wrestle.
  Leg& beside = legs_[other_end(leg)];
  if (one.tries % 2 == 1 || beside.back > 0.0 || beside.rest > 0.0) {
    one.back = kBackTime;
    return;
  }
  one.wedged = beside.wedged = true;
  one.rest = kBackTime;
  beside.q = measured.segment<kLegJoints>(kLegJoints * (other_end(leg)));
  beside.back = kBackTime;
  beside.tries = std::max(beside.tries, 1);
}

Vector3 LegFolding::target(int leg, const Vector12& measured) const noexcept {
  const int hip = kLegJoints * leg, thigh = hip + 1;
  const Leg& one = legs_[leg];
  if (one.rest > 0.0) return measured.segment<kLegJoints>(hip);
  if (one.back > 0.0) {
    Vector3 target = plan_.folded.segment<kLegJoints>(hip);
    const double left = target[1] - one.q[1];
    // Who is there already backs out the way it came.
    const double way = std::abs(left) < kNear ? target[1] : left;
    const double step = std::copysign(one.tries * kBackStep, way);
    target[0] = plan_.widest[hip];
    target[1] = std::clamp(one.q[1] - step, plan_.lower[thigh], plan_.upper[thigh]);
    target[2] = std::copysign(kOpenCalf, target[2]);
    return target;
  }
  return folding_target(plan_, leg, measured.segment<kLegJoints>(hip), reference_.q[thigh],
                        {one.time < kGently, roll_.rolls() > 0});
}

void LegFolding::follow(int joint, double wanted, double measured, double dt) noexcept {
  double &q = reference_.q[joint], &dq = reference_.dq[joint];
  const double left = wanted - q;
  const double lead = legs_[joint / kLegJoints].wedged ? kWedgedLead : kLead;
  const double ahead = std::copysign(1.0, left) * (q - measured) / lead;
  const double most = kSpeed * std::clamp(2.0 * (1.0 - ahead), 0.0, 1.0);
  const double speed = std::clamp(kPull * left, -most, most);
  dq += std::clamp(speed - dq, -kAcceleration * dt, kAcceleration * dt);
  q += dq * dt;
}

const JointReference& LegFolding::step(const Vector12& measured, const Vector3& up,
                                       double dt) noexcept {
  roll_.update(up, dt);
  if (roll_.lets_go()) {
    let_go(measured, up, dt);
    return reference_;
  }
  time_ += dt;
  bool others = true;
  done_ = true;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (!turns_.waits(leg)) move(leg, measured, dt);
    const bool folded = this->folded(leg, measured);
    others = others && (folded || turns_.waits(leg));
    done_ = done_ && folded;
  }
  turns_.update(others, dt);
  return reference_;
}

void LegFolding::move(int leg, const Vector12& measured, double dt) noexcept {
  legs_[leg].time += dt;
  watch(leg, measured, dt);
  const Vector3 wanted = target(leg, measured);
  for (int i = 0; i < kLegJoints; ++i) {
    const int joint = kLegJoints * leg + i;
    follow(joint, wanted[i], measured[joint], dt);
  }
}

}  // namespace surefoot
