// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// How far the ball feet have rolled on the ground since they were latched.
///
/// A foot of radius r that bears turns with its shank, and its contact point moves by r w x n
/// without slipping (w: of the shank, n: the ground's normal): by a tenth of the body's way. Feet
/// that bear nothing do not, and have no reason to go along. Real-time: yes.
class Rolling {
 public:
  explicit Rolling(double radius) noexcept : radius_(radius) {}

  void reset() noexcept { way_.setZero(); }

  /// @param contact belief per foot, 0 .. 1: how much of it rolls
  void update(const Dynamics& dynamics, const Vector3& normal, const Eigen::Vector4d& contact,
              double dt) noexcept {
    way_ *= 1.0 - dt / (dt + kForgetting);
    for (int leg = 0; leg < kLegs; ++leg) {
      const Vector3 rate = radius_ * dynamics.legs()[leg].w_world_shank.cross(normal);
      way_.col(leg) += contact[leg] * dt * rate;
    }
  }

  const FeetMatrix& way() const noexcept { return way_; }  ///< [m] FR FL RR RL, world axes

 private:
  // [s] Much longer than a push is answered for; feet that stay rolled stand where they are.
  static constexpr double kForgetting = 2.0;

  double radius_;
  FeetMatrix way_ = FeetMatrix::Zero();
};

}  // namespace surefoot
