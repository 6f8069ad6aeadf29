// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/joint_estimate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "dynamics/joint_friction.hpp"
#include "estimator/contact/leg_forces.hpp"

namespace surefoot {

namespace {

// All values are chosen. Test: test_joint_estimate.cpp, test_learnt_joints.py.
// [sqrt(g h)] Speed of a foot against the slowest foot above which it is in the air: 0.4 m/s at
// h = 0.3 m. If smaller: feet that slip or stick teach. If larger: slow swings teach nothing.
constexpr double kAirSpeed = 0.25;
// [s] Time for which a foot has been that fast before it is in the air. A soft sole drags on the
// ground for 25 ms while the foot already lifts off, and the drag looks like friction of the
// joints.
constexpr double kLiftTime = 0.02;
// [s] Time constant of the low-pass. If smaller: noise of ddq makes the armature too small. If
// larger: the swing itself does not pass.
constexpr double kFilterTime = 0.02;
// [tau_max] Standard deviation of the missing torque of one sample: torque sensor, wrong masses of
// the leg and the shocks of other feet.
constexpr double kTorqueSigma = 0.02;
// [s] Time for which the error of the missing torque is the same, a part of a swing. Samples of one
// such time count as one.
constexpr double kCorrelationTime = 0.04;
// [tau_max] Standard deviation of the part of the missing torque that does not average out.
constexpr double kModelSigma = 0.005;
// Initial standard deviation of the armature: this share of RobotConfig::armature, because models
// of one robot differ by a factor of two, plus this share of the joint's inertia in the standing
// pose, for a RobotConfig without armature.
constexpr double kArmatureSigma = 1.0, kInertiaSigma = 0.1;
// [largest damping] Initial standard deviation of the viscous friction.
constexpr double kDampingSigma = 1.0;
// [tau_max] Initial standard deviation of the Coulomb friction.
constexpr double kCoulombSigma = 0.05;
// [s] Swing time over which the memory fades to 1/e. Friction changes when a gear warms up.
constexpr double kMemoryTime = 10.0;
// Standard deviations beyond which the missing torque of a sample counts no more.
constexpr double kMaxDeviations = 3.0;

}  // namespace

JointEstimate::JointEstimate(const Robot& robot)
    : configured_(robot.config().armature), tau_max_(robot.config().tau_max.head<3>()) {
  Dynamics standing(robot);
  standing.update(robot.q_standing(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
  const double height = standing.p_world_com().z() - contact_points(standing).row(2).mean();
  air_speed_ = kAirSpeed * std::sqrt(kGravity * height);
  for (int k = 0; k < kLegJoints; ++k) {
    initial_sigma_(0, k) =
        kArmatureSigma * configured_[k] + kInertiaSigma * standing.legs()[0].M_leg(k, k);
    max_damping_[k] = tau_max_[k] / robot.config().no_load_speed[k];
    initial_sigma_(1, k) = kDampingSigma * max_damping_[k];
    initial_sigma_(2, k) = kCoulombSigma * tau_max_[k];
    kind_[k] = k;
    for (int j = k - 1; j >= 0; --j) {
      if (configured_[j] == configured_[k] && tau_max_[j] == tau_max_[k]) kind_[k] = j;
    }
  }
  reset();
}

void JointEstimate::reset() noexcept {
  for (int k = 0; k < kLegJoints; ++k) {
    regressions_[k] = {};
    regressions_[k].P = initial_sigma_.col(k).cwiseAbs2().asDiagonal();
  }
  legs_.fill({});
  started_ = false;
}

void JointEstimate::update(const JointInput& input, RobotState& state, double dt) noexcept {
  int slowest = 0;
  input.v_contact.colwise().squaredNorm().minCoeff(&slowest);
  const double blend = started_ ? dt / (dt + LegForces::kFilterTime) : 1.0;
  for (int i = 0; i < kLegs; ++i) {
    Leg& leg = legs_[i];
    const Vector3 q = input.q.segment<kLegJoints>(kLegJoints * i);
    leg.q += blend * (q - leg.q);
    const Vector3 dq = (q - leg.q) / LegForces::kFilterTime;
    const Vector3 ddq = (dq - leg.dq) / dt;
    leg.dq = dq;
    const double speed = (input.v_contact.col(i) - input.v_contact.col(slowest)).norm();
    leg.fast_time = speed >= air_speed_ ? leg.fast_time + dt : 0.0;
    if (leg.fast_time > kLiftTime) {
      learn_from_swing(i, terms(i, input, state, ddq), dt);
    } else {
      leg.low_passed = {};
    }
  }
  started_ = true;
  std::array<Vector3, kLegJoints> certain;
  for (int k = 0; k < kLegJoints; ++k) certain[k] = certain_part(k);
  for (int i = 0; i < kMotors; ++i) {
    const Vector3& x = certain[kind_[i % kLegJoints]];
    state.armature_error[i] = std::max(x[0], -configured_[i]);
    // A motor that reaches its no-load speed has less friction than tau_max there.
    state.joint_damping[i] = std::clamp(x[1], 0.0, max_damping_[i % kLegJoints]);
    state.joint_friction[i] = std::max(x[2], 0.0);
  }
}

// The joint errors that the dynamics contains are taken out, because the regression learns all of
// them.
JointEstimate::Terms JointEstimate::terms(int leg, const JointInput& input, const RobotState& state,
                                          const Vector3& ddq) const noexcept {
  const int first = kLegJoints * leg;
  Terms out;
  out.ddq = ddq;
  out.dq = legs_[leg].dq;
  out.sign = out.dq.unaryExpr(&smooth_sign);
  Matrix3 M = input.dynamics.legs()[leg].M_leg;
  M.diagonal() -= state.armature_error.segment<3>(first);
  out.missing = input.swing_torque.segment<3>(first) - M * ddq +
                state.joint_damping.segment<3>(first).cwiseProduct(out.dq) +
                state.joint_friction.segment<3>(first).cwiseProduct(out.sign);
  return out;
}

void JointEstimate::learn_from_swing(int leg, const Terms& terms, double dt) noexcept {
  const double blend = dt / (dt + kFilterTime);
  Terms& slow = legs_[leg].low_passed;
  slow.missing += blend * (terms.missing - slow.missing);
  slow.ddq += blend * (terms.ddq - slow.ddq);
  slow.dq += blend * (terms.dq - slow.dq);
  slow.sign += blend * (terms.sign - slow.sign);
  for (int k = 0; k < kLegJoints; ++k)
    learn(k, {slow.ddq[k], slow.dq[k], slow.sign[k]}, slow.missing[k], dt);
}

Vector3 JointEstimate::certain_part(int kind) const noexcept {
  const auto& [x, P, excitation, time] = regressions_[kind];
  const double sigma = kModelSigma * tau_max_[kind];
  Matrix3 information = excitation;
  information.diagonal() += initial_sigma_.col(kind).cwiseAbs2().cwiseInverse() * sigma * sigma;
  return information.inverse() * (excitation * x);
}

void JointEstimate::learn(int joint, const Vector3& regressor, double torque, double dt) noexcept {
  const int k = kind_[joint];
  auto& [x, P, excitation, time] = regressions_[k];
  time = std::min(time + dt, kMemoryTime);
  excitation += dt / time * (regressor * regressor.transpose() - excitation);
  const Vector3 gain = P * regressor;
  const double sigma = kTorqueSigma * tau_max_[k];
  const double expected = regressor.dot(gain);
  const double variance = expected + sigma * sigma * std::max(1.0, kCorrelationTime / dt);
  const double innovation = torque - regressor.dot(x);
  if (std::abs(innovation) > kMaxDeviations * std::sqrt(expected + sigma * sigma)) return;
  x += innovation / variance * gain;
  P -= gain * gain.transpose() / variance;
  // The memory fades, but no variance grows beyond its initial value.
  if ((P.diagonal().array() < initial_sigma_.col(k).cwiseAbs2().array()).all())
    P *= 1.0 + dt / kMemoryTime;
}

}  // namespace surefoot
