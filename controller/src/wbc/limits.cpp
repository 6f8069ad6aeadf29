// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/limits.hpp"

namespace surefoot {

namespace {

// From `lost` at no belief to `held` at full belief; nothing for a swing foot.
double by_belief(double lost, double held, double contact, bool stance) noexcept {
  const double belief = std::min(std::max(contact, 0.0), 1.0);
  return stance ? lost + belief * (held - lost) : 0.0;
}

}  // namespace

TorqueLimits torque_limits(const RobotConfig& config, const Vector12& dq) noexcept {
  TorqueLimits limits;
  for (int i = 0; i < kMotors; ++i) {
    limits(i, 0) = -motor_torque_limit(config, i, dq[i], -1.0);
    limits(i, 1) = motor_torque_limit(config, i, dq[i], 1.0);
  }
  return limits;
}

Eigen::Vector4d normal_force_limits(const Gains& gains, double weight,
                                    const Eigen::Vector4d& contact,
                                    const Reference& reference) noexcept {
  Eigen::Vector4d limits;
  for (int leg = 0; leg < kLegs; ++leg) {
    limits[leg] = weight * by_belief(gains.force_lost_contact, gains.force_max_contact,
                                     contact[leg], reference.feet[leg].stance);
  }
  return limits;
}

Eigen::Vector4d load_shares(const Gains& gains, const Eigen::Vector4d& contact,
                            const Reference& reference) noexcept {
  Eigen::Vector4d shares;
  for (int leg = 0; leg < kLegs; ++leg) {
    shares[leg] =
        by_belief(gains.share_lost_contact, 1.0, contact[leg], reference.feet[leg].stance);
  }
  return shares;
}

}  // namespace surefoot
