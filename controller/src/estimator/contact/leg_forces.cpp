// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/leg_forces.hpp"

#include <Eigen/LU>

namespace surefoot {

namespace {
constexpr double kMost = 1e4;   // [N] beyond this a leg is singular, and says nothing
constexpr double kStop = 0.03;  // [rad] nearer to its stop a joint may rest on it: they give, too
}  // namespace

Vector12 stops_at(const RobotConfig& config, const Vector12& q) noexcept {
  const auto upper = (q.array() > config.q_upper.array() - kStop).cast<double>();
  const auto lower = (q.array() < config.q_lower.array() + kStop).cast<double>();
  return upper - lower;
}

void LegForces::update(const Dynamics& dynamics, const Vector3& a_base, const Vector3& alpha_base,
                       const Vector12& tau_est, const Vector12& dq, const Vector12& stops,
                       double dt) noexcept {
  Vector6 base;
  base << a_base, alpha_base;
  const double blend = started_ ? dt / (dt + kTime) : 1.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const Vector3 now = tau_est.segment<3>(3 * leg) - L.h_leg - L.M_base_leg.transpose() * base;
    auto residual = residual_.segment<3>(3 * leg);
    auto smooth = dq_.segment<3>(3 * leg);
    residual += blend * (now - residual);
    smooth += blend * (dq.segment<3>(3 * leg) - smooth);
    const Vector3 ddq = (dq.segment<3>(3 * leg) - smooth) / kTime;
    Vector3 borne = L.M_leg * ddq - residual;  // J^T f, and what stops bear
    borne = (stops.segment<3>(3 * leg).array() * borne.array() < 0.0).select(0.0, borne);
    const Vector3 force = L.J_leg.transpose().inverse() * borne;
    if (force.cwiseAbs().maxCoeff() < kMost) forces_.col(leg) = force;
  }
  started_ = true;
}

}  // namespace surefoot
