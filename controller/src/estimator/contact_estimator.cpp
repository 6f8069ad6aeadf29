// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact_estimator.hpp"

#include <Eigen/LU>

namespace surefoot {

namespace {

constexpr double kForceFilter = 0.01;  // [s] smooths the torque-based force
constexpr double kJudgement = 0.1;     // [s] before the field is believed, or no longer
constexpr double kDenying = 0.25;      // share of the weight below which the field denies the load
constexpr double kCarrying = 0.5;      // share of the weight that shows the robot is carried

}  // namespace

void ContactEstimator::update(const Gains& gains, const Dynamics& dynamics, const Vector12& tau_est,
                              const std::array<std::int16_t, kLegs>& foot_force_est,
                              const Vector3& normal, double dt) noexcept {
  const double blend = dt / (dt + kForceFilter);
  for (int leg = 0; leg < kLegs; ++leg) {
    // tau = h - J'f at rest; leg inertia times joint acceleration is left out, it is small.
    const LegDynamics& L = dynamics.legs()[leg];
    const Vector3 tau = tau_est.segment<3>(3 * leg);
    const Vector3 force = L.J_leg.transpose().inverse() * (L.h_leg - tau);
    const double measured = force.allFinite() ? normal.dot(force) : 0.0;
    torque_force_[leg] += blend * (measured - torque_force_[leg]);
  }
  judge_foot_force(foot_force_est, dt);

  for (int leg = 0; leg < kLegs; ++leg) {
    const double load = alive_ ? foot_force_est[leg] : torque_force_[leg];
    const double threshold = loaded_[leg] ? gains.contact_force_off : gains.contact_force_on;
    loaded_[leg] = load > threshold * weight_;
    // A ramp over the dwell time: a single wrong sample moves the belief by one step only.
    const double step = gains.contact_dwell > dt ? dt / gains.contact_dwell : 1.0;
    const double moved = probability_[leg] + (loaded_[leg] ? step : -step);
    probability_[leg] = std::clamp(moved, 0.0, 1.0);
  }
}

void ContactEstimator::judge_foot_force(const std::array<std::int16_t, kLegs>& force,
                                        double dt) noexcept {
  const double sum = static_cast<double>(force[0]) + force[1] + force[2] + force[3];
  const bool carried = torque_force_.sum() > kCarrying * weight_;
  // In the air both are silent, and nothing is learnt about the field.
  const bool contradicts =
      alive_ ? carried && sum < kDenying * weight_ : carried && sum > kCarrying * weight_;
  contradiction_ = contradicts ? contradiction_ + dt : 0.0;
  if (contradiction_ > kJudgement) {
    alive_ = !alive_;
    contradiction_ = 0.0;
  }
}

}  // namespace surefoot
