// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Share of robot.friction that the force of each foot may use. Real-time: yes.
///
/// The ground is not known to hold what robot.friction says, and feet that push to their cone's
/// edge slide where it does not. So three tenths are kept for what takes them: the capture point,
/// now or after a tenth of a second more of what pushes the body, near the support's edge. They are
/// given at once and taken back in a tenth of a second, for forces must not step.
class UsableFriction {
 public:
  /// Take one step of time.
  /// @param mass [kg] of the robot
  /// @returns FR FL RR RL, 0 .. 1, no more than state.friction
  Eigen::Vector4d update(const Dynamics& dynamics, const RobotState& state,
                         const Reference& reference, double mass, double dt) noexcept;
  void reset() noexcept { share_ = 1.0; }

 private:
  double share_ = 1.0;
};

}  // namespace surefoot
