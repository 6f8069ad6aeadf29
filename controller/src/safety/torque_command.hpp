// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "safety/power_limiter.hpp"
#include "surefoot/stand_controller.hpp"

namespace surefoot {

/// From what the program decided to what the motors are told: the torques within the power that is
/// allowed, in torque mode. Real-time: yes.
class TorqueCommand {
 public:
  TorqueCommand(const Robot& robot, const StandOptions& options)
      : robot_(robot), options_(options) {}

  /// Take the torques of a usable solution. Where the power is limited the robot does less than the
  /// plan, of which the push observer and the delay predictor know nothing: the observer sees the
  /// rest as a push that holds it back (at most gain push_max), the predictor carries the state too
  /// far by as much of it as fits into the delay. Both end with the limiting.
  /// @return the solution's status, kSaturated where it was limited
  Status take(const Solution& solution, const Dynamics& dynamics, const RobotState& state,
              const Reference& reference, const Gains& gains) noexcept;

  /// Torque mode exactly; with motor damping the velocity loop is on and asks for rest.
  LowCmd command() const noexcept;

  const LimitedTorques& limited() const noexcept { return limited_; }
  void reset() noexcept { limited_ = {}; }

 private:
  Robot robot_;
  StandOptions options_;
  LimitedTorques limited_;  // motor order
};

}  // namespace surefoot
