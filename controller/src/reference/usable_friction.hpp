// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Share of RobotConfig::friction that the contact force of each foot may use.
///
/// The ground may have less friction than RobotConfig::friction. Feet that use the whole friction
/// cone would then slip. So the share is 0.7 while the capture point is far inside the support
/// polygon, and rises to 1 as the capture point approaches a support edge. The capture margin is
/// the smaller one of two: at the present velocity, and at the velocity after 0.1 s more of the
/// present external force. The share rises at once. It falls from 1 to 0.7 over 0.1 s, because a
/// sudden fall would make the contact forces jump. Real-time: yes.
///
/// On ground whose friction has been learnt, the share is one of the learnt friction.
class UsableFriction {
 public:
  /// Compute the shares of this tick.
  /// @param mass mass of the robot [kg]
  /// @param learnt_share learnt friction of the ground, as a share of RobotConfig::friction
  /// @return share of RobotConfig::friction for each foot, FR FL RR RL, 0 .. 1. The share never
  ///   exceeds state.friction, the share that the estimator allows
  Eigen::Vector4d update(const Dynamics& dynamics, const RobotState& state,
                         const Reference& reference, double mass, double learnt_share,
                         double dt) noexcept;
  void reset() noexcept { share_ = 1.0; }

 private:
  double share_ = 1.0;
};

}  // namespace surefoot
