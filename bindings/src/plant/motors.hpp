// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"

namespace surefoot::plant {

using Array12 = Eigen::Array<double, kMotors, 1>;
using Modes = Eigen::Array<std::uint8_t, kMotors, 1>;

/// A LowCmd's twelve motors, SI units, SDK order.
struct MotorCommands {
  Modes mode;
  Array12 q, dq, tau, kp, kd;
};

/// Commands and torques as the robot's drivers get them: on the wire tau is an int16 of
/// 1 / per_tau N.m, Kp a uint16 of 1/32 and Kd of 1/16, truncated toward zero. Values out of range
/// wrap there; here they saturate. A wire that is not real passes values through unchanged.
struct WireFormat {
  double per_tau = 256.0;
  bool real = true;

  double torque(double tau) const {
    return real ? std::trunc(std::clamp(tau * per_tau, -32767.0, 32767.0)) / per_tau : tau;
  }
  double gain(double value, double per_unit) const {
    return real ? std::trunc(std::clamp(value * per_unit, 0.0, 65535.0)) / per_unit : value;
  }
  /// What is not finite counts as not said.
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

/// The torque that a driver makes from its own joint: offset - kp q' - kd dq'; mode is what
/// LowState says of the motors meanwhile.
struct MotorLaw {
  Array12 offset = Array12::Zero(), kp = Array12::Zero(), kd = Array12::Zero();
  Modes mode = Modes::Constant(kModeServo);
};

/// tau' = tau + Kp (q - q') + Kd (dq - dq'). PosStopF (or any angle of 1e9 rad and more, as the
/// vendor's Python examples have it) switches the position term off, VelStopF the velocity term. A
/// motor in any mode but servo ignores all that and brakes.
inline MotorLaw command_law(const MotorCommands& command, double brake_kd) {
  constexpr double kPositionOff = 1e9;  // [rad] no joint turns so far
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

/// Turns the law in force into joint torques, one physics step at a time: torque-speed curve, a
/// first-order lag, exact for a target that holds for one step, a lasting error of each motor.
class Motors {
 public:
  Motors(const Array12& tau_max, const Array12& corner_speed, const Array12& no_load_speed,
         double share, const Array12& scale)
      : tau_max_(tau_max),
        slope_(tau_max / (no_load_speed - corner_speed)),
        stall_(slope_ * no_load_speed),
        scale_(scale),
        lag_blend_(share) {}

  MotorLaw law;
  Array12 estimated_torque = Array12::Zero();  ///< [N.m] that the drivers think they make
  Array12 torque = Array12::Zero();            ///< [N.m] that they make

  /// Full torque up to corner_speed, from there linear to zero at no_load_speed; a braking motor
  /// keeps its full torque.
  Array12 max_torque(const Array12& dq) const {
    return (stall_ - slope_ * dq).min(tau_max_).max(0.0);
  }

  const Array12& step(const Array12& q, const Array12& dq) {
    const Array12 up = max_torque(dq), down = -max_torque(-dq);
    const Array12 target = (law.offset - law.kp * q - law.kd * dq).max(down).min(up);
    estimated_torque += lag_blend_ * (target - estimated_torque);
    // A motor that errs upwards still makes no more than it can.
    torque = (scale_ * estimated_torque).max(down).min(up);
    return torque;
  }

 private:
  Array12 tau_max_, slope_, stall_, scale_;
  double lag_blend_;
};

}  // namespace surefoot::plant
