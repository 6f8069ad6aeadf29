// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// How far ball feet that bear have rolled lately.
///
/// A foot of radius r turns with its shank, and its contact point moves by r w x n without slipping
/// (w: of the shank, n: the ground's normal): by a tenth of the body's way. Feet that bear nothing
/// do not, and have no reason to go along. It is forgotten within seconds, for a robot that leans
/// for good stands on what it has rolled to, and bounded, for w has the gyroscope's errors.
/// Real-time: yes.
class FootRolling {
 public:
  explicit FootRolling(double radius) noexcept : radius_(radius) {}

  void reset() noexcept { displacement_.setZero(); }

  /// @param contact belief per foot, 0 .. 1: how much of it rolls
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
  static constexpr double kDecayTime = 2.0;  // [s] much longer than a push is answered for
  static constexpr double kMaxAngle = 0.4;   // [rad] that shanks turn under pushes that are stood

  double radius_;
  FeetMatrix displacement_ = FeetMatrix::Zero();
};

}  // namespace surefoot
