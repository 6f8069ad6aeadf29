// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/leg_forces.hpp"

#include <Eigen/LU>

namespace surefoot {

namespace {
// [N] A larger force is ignored, because only a singular leg can give it. Chosen far larger than
// any robot's weight.
constexpr double kMaxForce = 1e4;
// [rad] Distance to a stop below which a joint may rest on the stop. Chosen larger than the elastic
// deflection of a stop. If larger: joints of standing poses near a limit would count as resting on
// the stop, and a part of their contact force would be ignored.
constexpr double kStopMargin = 0.03;
}  // namespace

Vector12 joint_stops(const RobotConfig& config, const Vector12& q) noexcept {
  const auto upper = (q.array() > config.q_upper.array() - kStopMargin).cast<double>();
  const auto lower = (q.array() < config.q_lower.array() + kStopMargin).cast<double>();
  return upper - lower;
}

void LegForces::update(const Dynamics& dynamics, const Vector3& a_base, const Vector3& alpha_base,
                       const Vector12& tau_est, const Vector12& dq, const Vector12& stops,
                       double dt) noexcept {
  const double blend = started_ ? dt / (dt + kFilterTime) : 1.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const Vector3 unfiltered_residual =
        tau_est.segment<3>(3 * leg) - L.h_leg - L.M_base_leg.topRows<3>().transpose() * a_base;
    const Vector3 unfiltered_rotation = L.M_base_leg.bottomRows<3>().transpose() * alpha_base;
    auto residual = residual_.segment<3>(3 * leg);
    auto rotation = rotation_.segment<3>(3 * leg);
    auto dq_filtered = dq_filtered_.segment<3>(3 * leg);
    residual += blend * (unfiltered_residual - residual);
    rotation += blend * (unfiltered_rotation - rotation);
    dq_filtered += blend * (dq.segment<3>(3 * leg) - dq_filtered);
    const Vector3 ddq = (dq.segment<3>(3 * leg) - dq_filtered) / kFilterTime;
    auto friction = friction_.segment<3>(3 * leg);
    friction += blend * (dynamics.friction_torque().segment<3>(3 * leg) - friction);
    swing_torque_.segment<3>(3 * leg) = residual + friction - unfiltered_rotation;
    // J^T f plus the torques of the stops. A torque of the sign that the stop exerts is removed.
    Vector3 tau_contact = L.M_leg * ddq + rotation - residual;
    tau_contact =
        (stops.segment<3>(3 * leg).array() * tau_contact.array() < 0.0).select(0.0, tau_contact);
    const Vector3 force = L.J_leg.transpose().inverse() * tau_contact;
    if (force.cwiseAbs().maxCoeff() < kMaxForce) forces_.col(leg) = force;
  }
  started_ = true;
}

}  // namespace surefoot
