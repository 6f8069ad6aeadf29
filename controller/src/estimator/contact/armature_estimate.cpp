// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/armature_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/dynamics.hpp"

namespace surefoot {

namespace {

// All values are chosen. Test: test_armature_estimate.cpp, test_learnt_armature.py.
// [sqrt(g h)] Speed of a foot against the slowest foot above which it is in the air: 0.4 m/s at
// h = 0.3 m. If smaller: feet that slip or stick teach. If larger: slow swings teach nothing.
constexpr double kAirSpeed = 0.25;
// [s] Time constant of the low-pass. If smaller: noise of ddq makes the armature too small. If
// larger: the swing itself does not pass.
constexpr double kFilterTime = 0.02;
// [tau_max] Standard deviation of the missing torque of one sample: torque sensor, wrong masses of
// the leg and the shocks of other feet.
constexpr double kTorqueSigma = 0.02;
// [s] Time for which the error of the missing torque is the same, a part of a swing. Samples of one
// such time count as one.
constexpr double kCorrelationTime = 0.04;
// Initial standard deviation of the armature: this share of RobotConfig::armature, because models
// of one robot differ by a factor of two, plus this share of the joint's inertia in the standing
// pose, for a RobotConfig without armature.
constexpr double kArmatureSigma = 1.0, kInertiaSigma = 0.1;
// [1/s] Initial standard deviation of the viscous friction, as a share of the armature's.
constexpr double kDampingRate = 10.0;
// [tau_max] Initial standard deviation of the Coulomb friction.
constexpr double kCoulombSigma = 0.05;
// [rad/s] Speed at which the Coulomb friction has about its full value.
constexpr double kCoulombSpeed = 0.5;
// [s] Swing time over which the memory fades to 1/e. Friction changes when a gear warms up.
constexpr double kMemoryTime = 10.0;
// Standard deviations beyond which the missing torque of a sample counts no more.
constexpr double kMaxDeviations = 3.0;

}  // namespace

ArmatureEstimate::ArmatureEstimate(const Robot& robot)
    : configured_(robot.config().armature), tau_max_(robot.config().tau_max.head<3>()) {
  Dynamics standing(robot);
  standing.update(robot.q_standing(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
  const double height = standing.p_world_com().z() - contact_points(standing).row(2).mean();
  air_speed_ = kAirSpeed * std::sqrt(kGravity * height);
  inertia_ = standing.legs()[0].M_leg.diagonal();
  for (int k = 0; k < kLegJoints; ++k) {
    kind_[k] = k;
    for (int j = k - 1; j >= 0; --j) {
      if (configured_[j] == configured_[k] && tau_max_[j] == tau_max_[k]) kind_[k] = j;
    }
  }
  reset();
}

void ArmatureEstimate::reset() noexcept {
  for (int k = 0; k < kLegJoints; ++k) {
    regressions_[k].x.setZero();
    regressions_[k].P = initial_variances(k).asDiagonal();
  }
  terms_.fill({});
  error_.setZero();
}

Vector3 ArmatureEstimate::initial_variances(int kind) const noexcept {
  const double armature = kArmatureSigma * configured_[kind] + kInertiaSigma * inertia_[kind];
  return Vector3(armature, kDampingRate * armature, kCoulombSigma * tau_max_[kind]).cwiseAbs2();
}

void ArmatureEstimate::update(const ArmatureInput& input, double dt) noexcept {
  int slowest = 0;
  input.v_contact.colwise().squaredNorm().minCoeff(&slowest);
  for (int leg = 0; leg < kLegs; ++leg) {
    const double speed = (input.v_contact.col(leg) - input.v_contact.col(slowest)).norm();
    for (int motor = kLegJoints * leg; motor < kLegJoints * (leg + 1); ++motor) {
      if (speed < air_speed_) {
        terms_[motor] = {};
        continue;
      }
      filter(motor, input, dt);
      learn(motor, dt);
    }
  }
  for (int i = 0; i < kMotors; ++i)
    error_[i] = std::max(regressions_[kind_[i % kLegJoints]].x[0], -configured_[i]);
}

void ArmatureEstimate::filter(int motor, const ArmatureInput& input, double dt) noexcept {
  const double dq = input.dq[motor];
  const Vector3 regressor(input.ddq[motor], dq, std::tanh(dq / kCoulombSpeed));
  // input.missing_torque was computed with the learnt armature.
  const double missing = input.missing_torque[motor] + error_[motor] * input.ddq[motor];
  const double blend = dt / (dt + kFilterTime);
  Terms& terms = terms_[motor];
  terms.regressor += blend * (regressor - terms.regressor);
  terms.missing += blend * (missing - terms.missing);
}

void ArmatureEstimate::learn(int motor, double dt) noexcept {
  const int k = kind_[motor % kLegJoints];
  auto& [x, P] = regressions_[k];
  const Vector3& regressor = terms_[motor].regressor;
  const Vector3 gain = P * regressor;
  const double sigma = kTorqueSigma * tau_max_[k];
  const double expected = regressor.dot(gain);
  const double variance = expected + sigma * sigma * std::max(1.0, kCorrelationTime / dt);
  const double innovation = terms_[motor].missing - regressor.dot(x);
  if (std::abs(innovation) > kMaxDeviations * std::sqrt(expected + sigma * sigma)) return;
  x += innovation / variance * gain;
  P -= gain * gain.transpose() / variance;
  // The memory fades, but no variance grows beyond its initial value.
  if ((P.diagonal().array() < initial_variances(k).array()).all()) P *= 1.0 + dt / kMemoryTime;
}

}  // namespace surefoot
