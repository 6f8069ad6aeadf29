// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Share of RobotConfig::friction that the contact force of each foot may use.
///
/// The ground may have less friction than RobotConfig::friction, and feet that use the whole
/// friction cone would then slip. So 30 % are kept in reserve. The reserve is used when the capture
/// point, now or after 0.1 s more of the present external force, is near a support edge. It is
/// released at once and withdrawn within 0.1 s, because contact forces must not step.
/// Real-time: yes.
class UsableFriction {
 public:
  /// Compute the share of this tick.
  /// @param mass [kg] of the robot
  /// @return FR FL RR RL, 0 .. 1, at most state.friction
  Eigen::Vector4d update(const Dynamics& dynamics, const RobotState& state,
                         const Reference& reference, double mass, double dt) noexcept;
  void reset() noexcept { share_ = 1.0; }

 private:
  double share_ = 1.0;
};

}  // namespace surefoot
