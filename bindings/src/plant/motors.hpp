// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"

namespace surefoot::plant {

using Array12 = Eigen::Array<double, kMotors, 1>;
using Modes = Eigen::Array<std::uint8_t, kMotors, 1>;

/// Commands of the twelve motors in a LowCmd, SI units, SDK motor order.
struct MotorCommands {
  Modes mode;                  ///< motor modes
  Array12 q, dq, tau, kp, kd;  ///< [rad], [rad/s], [N.m], [N.m/rad], [N.m.s/rad]
};

/// Quantisation of commands and torques on the wire: tau is an int16 in units of 1 / per_tau N.m,
/// Kp a uint16 in units of 1/32 and Kd in units of 1/16, truncated towards zero. Source: frames of
/// unitree_legged_sdk (A1, Go1: 1/256 N.m; B1: 1/128), measured on the vendor's library. The
/// vendor's library wraps values that are out of range; this model saturates them.
struct WireFormat {
  double per_tau = 256.0;  ///< [counts/(N.m)] 128 on a B1
  bool real = true;        ///< false: values do not change

  /// Return a torque [N.m] after transmission.
  double torque(double tau) const {
    return real ? std::trunc(std::clamp(tau * per_tau, -32767.0, 32767.0)) / per_tau : tau;
  }
  /// Return a gain after transmission with `per_unit` counts per unit.
  double gain(double value, double per_unit) const {
    return real ? std::trunc(std::clamp(value * per_unit, 0.0, 65535.0)) / per_unit : value;
  }
  /// Return the motor commands of a LowCmd. A value that is not finite counts as not set: it
  /// becomes PosStopF, VelStopF or 0.
  MotorCommands read(const LowCmd& cmd) const {
    const auto finite_or = [](double value, double otherwise) {
      return std::isfinite(value) ? value : otherwise;
    };
    MotorCommands out;
    for (int i = 0; i < kMotors; ++i) {
      const MotorCmd motor = cmd.motorCmd[i];
      out.mode[i] = motor.mode;
      out.q[i] = finite_or(motor.q, PosStopF);
      out.dq[i] = finite_or(motor.dq, VelStopF);
      out.tau[i] = torque(finite_or(motor.tau, 0.0));
      out.kp[i] = gain(finite_or(motor.Kp, 0.0), 32.0);
      out.kd[i] = gain(finite_or(motor.Kd, 0.0), 16.0);
    }
    return out;
  }
};

/// Torque law of the motor drivers: tau' = offset - kp q' - kd dq', where q' and dq' are the
/// measured joint angle and velocity. `mode` is the motor mode that LowState reports under this
/// law.
struct MotorLaw {
  Array12 offset = Array12::Zero(), kp = Array12::Zero(), kd = Array12::Zero();
  Modes mode = Modes::Constant(kModeServo);
};

/// Return the law tau' = tau + Kp (q - q') + Kd (dq - dq') of a command. q = PosStopF, or any |q|
/// of at least 1e9 rad, switches the position term off. dq = VelStopF switches the velocity term
/// off. A motor that is not in servo mode ignores its command and brakes.
/// @param brake_kd Kd of a motor that brakes [N.m.s/rad]
inline MotorLaw command_law(const MotorCommands& command, double brake_kd) {
  // [rad] |q| from which q is not a position command: PosStopF of the vendor's Python examples. It
  // must be below PosStopF of comm.h (2.146e9).
  constexpr double kPositionOff = 1e9;
  MotorLaw law;
  for (int i = 0; i < kMotors; ++i) {
    const bool brakes = command.mode[i] != kModeServo;
    law.mode[i] = brakes ? kModeDamping : kModeServo;
    law.kp[i] = brakes || std::abs(command.q[i]) >= kPositionOff ? 0.0 : command.kp[i];
    law.kd[i] = brakes ? brake_kd : std::abs(command.dq[i]) >= VelStopF ? 0.0 : command.kd[i];
    law.offset[i] =
        brakes ? 0.0 : command.tau[i] + law.kp[i] * command.q[i] + law.kd[i] * command.dq[i];
  }
  return law;
}

/// Simulated motors: compute joint torques from the present motor law, one physics step at a time.
///
/// Models the torque-speed curve, a first-order lag (exact for a target that is constant in a
/// step), and a constant scale error of each motor.
class Motors {
 public:
  /// @param tau_max [N.m] torque limit up to corner_speed
  /// @param corner_speed [rad/s] velocity at which the limit starts to fall
  /// @param no_load_speed [rad/s] velocity at which the limit reaches zero
  /// @param share share by which the torque approaches its target in a physics step, 0 .. 1
  /// @param scale factor on the torque of each motor
  Motors(const Array12& tau_max, const Array12& corner_speed, const Array12& no_load_speed,
         double share, const Array12& scale)
      : tau_max_(tau_max),
        slope_(tau_max / (no_load_speed - corner_speed)),
        stall_(slope_ * no_load_speed),
        scale_(scale),
        lag_blend_(share) {}

  MotorLaw law;
  Array12 estimated_torque = Array12::Zero();  ///< [N.m] torque that the drivers estimate
  Array12 torque = Array12::Zero();            ///< [N.m] torque that the motors produce

  /// Return the largest torques [N.m] at dq [rad/s]: tau_max up to corner_speed, then falling
  /// linearly to zero at no_load_speed. A torque against the velocity may always reach tau_max.
  Array12 max_torque(const Array12& dq) const {
    return (stall_ - slope_ * dq).min(tau_max_).max(0.0);
  }

  /// Advance by one physics step at joint angles q [rad] and velocities dq [rad/s]; return the
  /// torques [N.m].
  const Array12& step(const Array12& q, const Array12& dq) {
    const Array12 up = max_torque(dq), down = -max_torque(-dq);
    const Array12 target = (law.offset - law.kp * q - law.kd * dq).max(down).min(up);
    estimated_torque += lag_blend_ * (target - estimated_torque);
    // A motor with a scale above 1 still stays within its torque limits.
    torque = (scale_ * estimated_torque).max(down).min(up);
    return torque;
  }

 private:
  Array12 tau_max_, slope_, stall_, scale_;
  double lag_blend_;
};

}  // namespace surefoot::plant
