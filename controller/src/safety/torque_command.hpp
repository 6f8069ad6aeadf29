// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "safety/power_limiter.hpp"
#include "safety/runaway_legs.hpp"
#include "surefoot/gains.hpp"
#include "surefoot/robot.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Return a command with these torques [N.m], motor order. Motors with kd = 0 are in pure torque
/// mode. Motors with kd > 0 also get motor-side damping (Kd = kd [N.m.s/rad], dq = 0). Real-time:
/// yes.
LowCmd torque_low_cmd(const Vector12& torques, const Vector12& kd) noexcept;

/// Converts the torques of the QP or of the fallback chain to a LowCmd in torque mode.
///
/// The class limits the power of the command, first that of swing legs, because the robot falls
/// without the torques of the legs that carry it. It then limits the torques of runaway legs, and
/// makes a lost leg damp. Real-time: yes.
class TorqueCommand {
 public:
  /// @param motor_damping motor-side damping of every command [N.m.s/rad]
  /// @param power_limit largest power of a command [W]
  TorqueCommand(const Robot& robot, double motor_damping, double power_limit)
      : robot_(robot), motor_damping_(motor_damping), power_limit_(power_limit) {}

  /// Update the present joint velocities. Call it after each estimate, before set_torques(), which
  /// limits the power at these velocities and at those of its state. @param dt time since the last
  /// estimate [s]
  void observe_joints(const RobotState& state, double dt) noexcept {
    present_speeds_ = joint_speeds(state);
    runaway_legs_.update(present_speeds_, dt);
  }

  /// Set the lost leg: 0 .. 3, or -1 for none. The motors of a lost leg damp and get no torques.
  void set_lost_leg(int leg) noexcept { lost_leg_ = leg; }

  /// Set the torques for the next command() to those of a usable solution, and limit their power.
  /// limited().scale includes neither swing legs, see swing_scale, nor runaway legs.
  /// @return the status of the solution, or kSaturated if the torques were limited
  Status set_torques(const Solution& solution, const Dynamics& dynamics, const RobotState& state,
                     const Reference& reference, const Gains& gains) noexcept;

  /// Set the torques for the next command() to `tau`, for torques that do not come from a Solution,
  /// and limit their power in the same way.
  /// @param tau motor order [N.m]
  /// @param damping motor-side damping [N.m.s/rad], added to the option motor_damping
  /// @return whether the torques were limited
  bool set_torques(const Vector12& tau, double damping, const Dynamics& dynamics,
                   const RobotState& state, const Reference& reference,
                   const Gains& gains) noexcept;

  /// Return the command with the torques of the last set_torques(). @param dt time since the last
  /// call [s]
  LowCmd command(double dt) noexcept;

  /// See WholeBodyController::set_torque_share().
  void set_torque_share(const Vector12& share) noexcept { torque_share_ = share; }

  const LimitedTorques& limited() const noexcept { return limited_; }
  void reset() noexcept {
    limited_ = {};
    present_speeds_.setZero();
    runaway_legs_.reset();
    lost_leg_ = -1;
    lost_damping_share_ = 0.0;
  }

 private:
  LimitedTorques limit_swing_legs_first(const Vector12& tau, const Vector12& hold,
                                        const Vector12& dq, const Reference& reference,
                                        double watts) const noexcept;
  void limit_at_present_speeds(const Vector12& hold, const Vector12& dq, const Reference& reference,
                               double watts) noexcept;
  Vector12 joint_speeds(const RobotState& state) const noexcept;
  bool limit_runaway_legs(const Vector12& dq, const Reference& reference) noexcept;

  Robot robot_;
  double motor_damping_;    // [N.m.s/rad]
  double power_limit_;      // [W]
  LimitedTorques limited_;  // motor order
  RunawayLegs runaway_legs_;
  Vector12 present_speeds_ = Vector12::Zero();  // [rad/s] of the last observe_joints()
  int lost_leg_ = -1;
  Vector12 torque_share_ = Vector12::Ones();  // usable share of each motor's torque limit
  // [N.m.s/rad] Damping of the present command, option motor_damping included.
  double damping_ = 0.0;
  // Lost leg: final damping [N.m.s/rad], and the share of the final damping that has been reached,
  // 0 .. 1.
  double lost_damping_ = 0.0, lost_damping_share_ = 0.0;
};

}  // namespace surefoot
