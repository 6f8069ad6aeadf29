// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dds/wire/wire_types.hpp"
#include "surefoot/dds_robot.hpp"
#include "surefoot/frames.hpp"

namespace surefoot {

/// Convert a command to the DDS type, CRC included. Real-time: yes.
///
/// All 20 motors get the servo mode of the robot, because mode 0 switches a motor off. A motor
/// whose mode is not kModeServo gets damping instead: q = PosStopF, dq = tau = kp = 0, kd =
/// `damping_kd`. The battery command is always 0. If a number is not finite, the result is
/// kNotFinite, and `out` keeps its old value.
/// @param damping_kd [N.m.s/rad]
FrameReport to_dds(const LowCmd& cmd, DdsRobot robot, double damping_kd, DdsLowCmd& out) noexcept;

/// Convert a command from the DDS type, as a robot reads it. Real-time: yes.
///
/// Motors for which is_servo_command() is true get kModeServo, all others kModeDamping. The result
/// is kBlank, kWrongCrc or kNotFinite if the command is refused; `out` then keeps its old value.
FrameReport from_dds(const DdsLowCmd& wire, DdsRobot robot, CrcRule crc, LowCmd& out) noexcept;

}  // namespace surefoot
