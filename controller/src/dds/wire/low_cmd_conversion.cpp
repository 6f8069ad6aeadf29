// SPDX-License-Identifier: BSD-3-Clause
#include "dds/wire/low_cmd_conversion.hpp"

#include <cstring>

#include "dds/wire/wire_check.hpp"
#include "dds/wire/wire_robot.hpp"

namespace surefoot {

namespace {

void write_motor(const MotorCmd& from, double damping_kd, DdsMotorCmd& to) noexcept {
  if (from.mode == kModeServo) {
    to.q = from.q;
    to.dq = from.dq;
    to.tau = from.tau;
    to.kp = from.Kp;
    to.kd = from.Kd;
  } else {
    to.q = static_cast<float>(PosStopF);
    to.dq = to.tau = to.kp = 0.0F;
    to.kd = static_cast<float>(damping_kd);
  }
  std::memcpy(to.reserve, from.reserve.data(), sizeof(to.reserve));
}

void check_motors(const DdsLowCmd& cmd, FrameReport& report) noexcept {
  for (int i = 0; i < kMotorSlots; ++i) {
    const DdsMotorCmd& motor = cmd.motor_cmd[i];
    check_finite(motor.q, "q", i, report);
    check_finite(motor.dq, "dq", i, report);
    check_finite(motor.tau, "tau", i, report);
    check_finite(motor.kp, "Kp", i, report);
    check_finite(motor.kd, "Kd", i, report);
  }
}

}  // namespace

FrameReport to_dds(const LowCmd& cmd, DdsRobot robot, double damping_kd, DdsLowCmd& out) noexcept {
  DdsLowCmd wire;
  std::memset(&wire, 0, sizeof(wire));
  wire.head[0] = 0xFE;
  wire.head[1] = 0xEF;
  wire.level_flag = LOWLEVEL;
  wire.frame_reserve = cmd.frameReserve;
  std::memcpy(wire.sn, cmd.SN.data(), sizeof(wire.sn));
  std::memcpy(wire.version, cmd.version.data(), sizeof(wire.version));
  wire.bandwidth = cmd.bandWidth;
  for (int i = 0; i < kMotorSlots; ++i) {
    wire.motor_cmd[i].mode = servo_mode(robot);
    write_motor(cmd.motorCmd[i], damping_kd, wire.motor_cmd[i]);
  }
  std::memcpy(wire.wireless_remote, cmd.wirelessRemote.data(), sizeof(wire.wireless_remote));
  wire.reserve = cmd.reserve;
  FrameReport report;
  report.size = sizeof(wire);
  check_motors(wire, report);
  if (!is_usable(report.status)) return report;
  wire.crc = wire_crc(wire);
  std::memcpy(&out, &wire, sizeof(wire));
  return report;
}

FrameReport from_dds(const DdsLowCmd& wire, DdsRobot robot, CrcRule crc, LowCmd& out) noexcept {
  FrameReport report = check_wire(wire, crc);
  check_motors(wire, report);
  if (!is_usable(report.status)) return report;
  LowCmd cmd = init_low_cmd();
  cmd.frameReserve = wire.frame_reserve;
  std::memcpy(cmd.SN.data(), wire.sn, sizeof(wire.sn));
  std::memcpy(cmd.version.data(), wire.version, sizeof(wire.version));
  cmd.bandWidth = wire.bandwidth;
  for (int i = 0; i < kMotorSlots; ++i) {
    const DdsMotorCmd& from = wire.motor_cmd[i];
    MotorCmd& to = cmd.motorCmd[i];
    to.mode = is_servo_command(robot, from.mode) ? kModeServo : kModeDamping;
    to.q = from.q;
    to.dq = from.dq;
    to.tau = from.tau;
    to.Kp = from.kp;
    to.Kd = from.kd;
    std::memcpy(to.reserve.data(), from.reserve, sizeof(from.reserve));
  }
  cmd.bms.off = wire.bms_cmd.off;
  std::memcpy(cmd.bms.reserve.data(), wire.bms_cmd.reserve, sizeof(wire.bms_cmd.reserve));
  std::memcpy(cmd.wirelessRemote.data(), wire.wireless_remote, sizeof(wire.wireless_remote));
  cmd.reserve = wire.reserve;
  cmd.crc = wire.crc;
  out = cmd;
  return report;
}

}  // namespace surefoot
