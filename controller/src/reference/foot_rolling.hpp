// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Displacement of the contact points by rolling of the spherical feet within the last seconds.
///
/// A loaded foot of radius r rotates with its shank, and its contact point moves at r w x n without
/// slip (w: angular velocity of the shank, n: ground normal). This is about a tenth of the body's
/// displacement. The displacement decays within seconds, because a robot that leans permanently
/// stands on its new contact points. It is bounded, because w has the gyroscope's errors.
/// Real-time: yes.
class FootRolling {
 public:
  explicit FootRolling(double radius) noexcept : radius_(radius) {}

  void reset() noexcept { displacement_.setZero(); }

  /// Integrate one tick.
  /// @param contact contact confidence per foot, 0 .. 1; scales the rolling
  void update(const Dynamics& dynamics, const Vector3& normal, const Eigen::Vector4d& contact,
              double dt) noexcept {
    displacement_ *= 1.0 - dt / (dt + kDecayTime);
    displacement_ += dt * rolling_velocities(dynamics, contact, radius_ * normal);
    for (int leg = 0; leg < kLegs; ++leg) {
      const double turned = displacement_.col(leg).norm() / std::max(radius_, 1e-6);
      displacement_.col(leg) *= std::min(1.0, kMaxAngle / std::max(turned, 1e-6));
    }
  }

  const FeetMatrix& displacement() const noexcept {
    return displacement_;
  }  ///< [m] FR FL RR RL, world axes

 private:
  static constexpr double kDecayTime = 2.0;  // [s] much longer than a reaction to a push
  static constexpr double kMaxAngle = 0.4;   // [rad] shanks rotate less under survivable pushes

  double radius_;
  FeetMatrix displacement_ = FeetMatrix::Zero();
};

}  // namespace surefoot
