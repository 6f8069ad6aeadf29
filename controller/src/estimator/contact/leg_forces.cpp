// SPDX-License-Identifier: BSD-3-Clause
#include "estimator/contact/leg_forces.hpp"

#include <Eigen/LU>

namespace surefoot {

namespace {
constexpr double kMost = 1e4;  // [N] beyond this a leg is singular, and says nothing
}

void LegForces::update(const Dynamics& dynamics, const Vector3& a_base, const Vector3& alpha_base,
                       const Vector12& tau_est, const Vector12& dq, double dt) noexcept {
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
    const Vector3 force = L.J_leg.transpose().inverse() * (L.M_leg * ddq - residual);
    if (force.cwiseAbs().maxCoeff() < kMost) forces_.col(leg) = force;
  }
  started_ = true;
}

}  // namespace surefoot
