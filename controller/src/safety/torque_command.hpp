// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "safety/power_limiter.hpp"
#include "safety/runaway_legs.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Torques [N.m], motor order, in torque mode exactly; with the motors' own damping
/// (kd > 0 [N.m.s/rad]) the velocity loop is on and asks for rest. Real-time: yes.
LowCmd torque_low_cmd(const Vector12& torques, const Vector12& kd) noexcept;

/// From what the program decided to what the motors are told: the torques within the power that is
/// allowed, in torque mode. Real-time: yes.
class TorqueCommand {
 public:
  /// @param motor_damping [N.m.s/rad] added to every command @param power_limit [W] most it may
  /// take
  TorqueCommand(const Robot& robot, double motor_damping, double power_limit)
      : robot_(robot), motor_damping_(motor_damping), power_limit_(power_limit) {}

  /// Look at the joints, with every estimate. @param dt [s] since the last
  void observe_joints(const RobotState& state, double dt) noexcept {
    runaway_legs_.update(joint_speeds(state), dt);
  }

  /// @param leg whose motors get no torques and damp from now on, from 0 on; -1: none
  void set_lost_leg(int leg) noexcept { lost_leg_ = leg; }

  /// Take the torques of a usable solution, less of them where the power is limited:
  /// limited().scale is the share of the planned motion that is left, but for legs that are flung.
  /// @return the solution's status, kSaturated where it was limited
  Status take(const Solution& solution, const Dynamics& dynamics, const RobotState& state,
              const Reference& reference, const Gains& gains) noexcept;

  /// The same for torques in motor order [N.m], to which the motors add damping [N.m.s/rad] beyond
  /// the option's. @return were they limited?
  bool take(const Vector12& tau, double damping, const Dynamics& dynamics, const RobotState& state,
            const Reference& reference, const Gains& gains) noexcept;

  /// @param dt [s] since the last
  LowCmd command(double dt) noexcept;

  /// See WholeBodyController::set_torque_share().
  void set_torque_share(const Vector12& share) noexcept { torque_share_ = share; }

  const LimitedTorques& limited() const noexcept { return limited_; }
  void reset() noexcept {
    limited_ = {};
    runaway_legs_.reset();
    lost_leg_ = -1;
    lost_damping_share_ = 0.0;
  }

 private:
  Vector12 joint_speeds(const RobotState& state) const noexcept;
  bool limit_runaway_legs(const Vector12& dq) noexcept;

  Robot robot_;
  double motor_damping_;    // [N.m.s/rad]
  double power_limit_;      // [W]
  LimitedTorques limited_;  // motor order
  RunawayLegs runaway_legs_;
  int lost_leg_ = -1;
  Vector12 torque_share_ = Vector12::Ones();  // of each motor
  double damping_ = 0.0;                      // [N.m.s/rad]
  double lost_damping_ = 0.0,
         lost_damping_share_ = 0.0;  // [N.m.s/rad] of the lost leg; its share by now
};

}  // namespace surefoot
