// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Displacement of the contact points that the rolling of the spherical feet causes.
///
/// A loaded foot of radius r rotates with its shank. Without slip, its contact point then moves
/// with velocity r (w x n), where w is the angular velocity of the shank and n the ground normal.
/// The displacement of a contact point is about a tenth of the body's displacement. The stored
/// displacement decays within seconds: if the robot leans for longer, its present contact points
/// become the reference. The stored displacement is also bounded, because w contains the errors of
/// the gyroscope. Real-time: yes.
class FootRolling {
 public:
  explicit FootRolling(double radius) noexcept : radius_(radius) {}

  void reset() noexcept { displacement_.setZero(); }

  /// Integrate the rolling of one tick.
  /// @param normal ground normal, unit length, world axes
  /// @param contact contact confidence of each foot, 0 .. 1, which scales the rolling of the foot
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
  // [s] Time constant of the decay. Chosen longer than the reaction to a push, some tenths of a
  // second, and short enough that the present contact points of a leaning robot soon become the
  // reference.
  static constexpr double kDecayTime = 2.0;
  // [rad] Bound of the displacement, divided by the radius of the foot: rotation of the shank.
  // Chosen larger than the rotation of the shanks in pushes that the robot survives, and small
  // enough that errors of the gyroscope cannot add up.
  static constexpr double kMaxAngle = 0.4;

  double radius_;
  FeetMatrix displacement_ = FeetMatrix::Zero();
};

}  // namespace surefoot
