// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/joint_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/joint_friction.hpp"
#include "dynamics/standing_pose.hpp"
#include "estimator/contact/leg_forces.hpp"

namespace surefoot {

namespace {

// All values are chosen. Test: test_joint_estimate.cpp, test_learnt_joints.py.
// [sqrt(g h)] Speed of a foot against the slowest foot above which it is in the air: 0.4 m/s at
// h = 0.3 m. If smaller: feet that slip or stick count. If larger: slow swings do not count.
constexpr double kAirSpeed = 0.25;
// [s] Time for which a foot has been that fast before it is in the air. A soft sole drags on the
// ground for 25 ms while the foot already lifts off, and the drag looks like friction of the
// joints.
constexpr double kLiftTime = 0.02;
// [s] Time constant of the low-pass. If smaller: noise of ddq makes the armature too small. If
// larger: the swing itself does not pass.
constexpr double kFilterTime = 0.02;
// Initial standard deviation of the armature: this share of RobotConfig::armature, because models
// of one robot differ by a factor of two, plus this share of the joint's inertia in the standing
// pose, for a RobotConfig without armature.
constexpr double kArmatureSigma = 1.0, kInertiaSigma = 0.1;
// [tau_max] Initial standard deviation of the Coulomb friction.
constexpr double kCoulombSigma = 0.05;

bool same_kind(const RobotConfig& config, int a, int b) {
  return config.armature[a] == config.armature[b] && config.tau_max[a] == config.tau_max[b] &&
         config.no_load_speed[a] == config.no_load_speed[b];
}

}  // namespace

// A motor that reaches its no-load speed has less friction than tau_max there.
JointEstimate::JointEstimate(const Robot& robot)
    : configured_(robot.config().armature),
      max_damping_(robot.config().tau_max.cwiseQuotient(robot.config().no_load_speed)) {
  const Dynamics standing = standing_dynamics(robot);
  air_speed_ = kAirSpeed * std::sqrt(kGravity * standing_com_height(robot));
  for (int i = 0; i < kMotors; ++i) {
    first_of_kind_[i] = 0;
    while (!same_kind(robot.config(), i, first_of_kind_[i])) ++first_of_kind_[i];
    const double inertia = standing.legs()[i / kLegJoints].M_leg.diagonal()[i % kLegJoints];
    const double tau_max = robot.config().tau_max[i];
    initial_[i] = {tau_max,
                   {kArmatureSigma * configured_[i] + kInertiaSigma * inertia, max_damping_[i],
                    kCoulombSigma * tau_max}};
  }
  reset();
}

void JointEstimate::reset() noexcept {
  regressions_ = initial_;
  take_results();
  pause();
}

void JointEstimate::pause() noexcept {
  legs_.fill({});
  started_ = false;
}

void JointEstimate::update(const JointInput& input, double dt) noexcept {
  if (dt > kLiftTime) pause();  // a gap: the signals between the samples are unknown
  int slowest = 0;
  input.v_contact.colwise().squaredNorm().minCoeff(&slowest);
  for (int i = 0; i < kLegs; ++i) {
    observe(i, input, dt);
    Leg& leg = legs_[i];
    const double speed = (input.v_contact.col(i) - input.v_contact.col(slowest)).norm();
    leg.fast_time = speed >= air_speed_ ? leg.fast_time + dt : 0.0;
    if (leg.fast_time > kLiftTime) {
      learn(i, input.stops, dt);
    } else {
      leg.low_passed = {};
    }
  }
  started_ = true;
  take_results();
}

// Compute the terms of this tick. swing_torque contains no joint friction; the armature error is
// taken out of M here.
void JointEstimate::observe(int index, const JointInput& input, double dt) noexcept {
  Leg& leg = legs_[index];
  Terms& terms = leg.terms;
  const int first = kLegJoints * index;
  const Vector3 q = input.q.segment<kLegJoints>(first);
  if (!started_) leg.q = leg.last_q = q;
  const double blend = dt / (dt + LegForces::kFilterTime);
  leg.q += blend * (q - leg.q);
  const Vector3 dq = (q - leg.q) / LegForces::kFilterTime;
  const Vector3 sign = ((q - leg.last_q) / dt).unaryExpr(&smooth_sign);
  leg.last_q = q;
  terms.ddq = (dq - terms.dq) / dt;
  terms.dq = dq;
  terms.sign += blend * (sign - terms.sign);
  Matrix3 M = input.dynamics.legs()[index].M_leg;
  M.diagonal() -= armature_error_.segment<kLegJoints>(first);
  terms.torque = input.swing_torque.segment<kLegJoints>(first) - M * terms.ddq;
}

void JointEstimate::learn(int index, const Vector12& stops, double dt) noexcept {
  const double blend = dt / (dt + kFilterTime);
  const Terms& terms = legs_[index].terms;
  Terms& slow = legs_[index].low_passed;
  slow.torque += blend * (terms.torque - slow.torque);
  slow.ddq += blend * (terms.ddq - slow.ddq);
  slow.dq += blend * (terms.dq - slow.dq);
  slow.sign += blend * (terms.sign - slow.sign);
  for (int k = 0; k < kLegJoints; ++k) {
    const int motor = kLegJoints * index + k;
    if (stops[motor] != 0.0) continue;  // the stop may exert a torque
    regressions_[first_of_kind_[motor]].learn({slow.ddq[k], slow.dq[k], slow.sign[k]},
                                              slow.torque[k], dt);
  }
}

void JointEstimate::take_results() noexcept {
  std::array<Vector3, kMotors> results;
  for (int i = 0; i < kMotors; ++i) {
    const int first = first_of_kind_[i];
    if (first == i) results[i] = regressions_[i].result();
    const Vector3& result = results[first];
    armature_error_[i] = std::max(result[0], -configured_[i]);
    // With more friction a swing would take all torque of the motor, so none is compensated.
    damping_[i] = result[1] > max_damping_[i] ? 0.0 : std::max(result[1], 0.0);
    friction_[i] = std::max(result[2], 0.0);
  }
}

}  // namespace surefoot
