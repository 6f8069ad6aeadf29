// SPDX-License-Identifier: BSD-3-Clause
#include "dds/wire/low_state_conversion.hpp"

#include <cstring>

#include "dds/wire/wire_check.hpp"
#include "dds/wire/wire_robot.hpp"

namespace surefoot {

namespace {

// Chosen: no motor or battery reaches 200 deg C, so bytes from here on are negative temperatures.
// The vendor's ROS messages have signed temperatures, its DDS types unsigned ones.
constexpr std::uint8_t kFirstNegative = 200;

std::int8_t temperature(std::uint8_t byte) noexcept {
  return static_cast<std::int8_t>(byte < kFirstNegative ? std::min<int>(byte, 127) : byte - 256);
}
std::uint8_t byte_of(std::int8_t degrees) noexcept { return static_cast<std::uint8_t>(degrees); }

void check_floats(const DdsLowState& state, FrameReport& report) noexcept {
  const DdsImuState& imu = state.imu_state;
  for (const float value : imu.quaternion) check_finite(value, "quaternion", -1, report);
  for (const float value : imu.gyroscope) check_finite(value, "gyroscope", -1, report);
  for (const float value : imu.accelerometer) check_finite(value, "accelerometer", -1, report);
  for (const float value : imu.rpy) check_finite(value, "rpy", -1, report);
  for (int i = 0; i < kMotors; ++i) {  // the slots behind them belong to no motor
    const DdsMotorState& motor = state.motor_state[i];
    check_finite(motor.q, "q", i, report);
    check_finite(motor.dq, "dq", i, report);
    check_finite(motor.ddq, "ddq", i, report);
    check_finite(motor.tau_est, "tauEst", i, report);
    check_finite(motor.q_raw, "q_raw", i, report);
    check_finite(motor.dq_raw, "dq_raw", i, report);
    check_finite(motor.ddq_raw, "ddq_raw", i, report);
  }
}

void read_imu(const DdsImuState& from, IMU& to) noexcept {
  std::memcpy(to.quaternion.data(), from.quaternion, sizeof(from.quaternion));
  std::memcpy(to.gyroscope.data(), from.gyroscope, sizeof(from.gyroscope));
  std::memcpy(to.accelerometer.data(), from.accelerometer, sizeof(from.accelerometer));
  std::memcpy(to.rpy.data(), from.rpy, sizeof(from.rpy));
  to.temperature = temperature(from.temperature);
}

void write_imu(const IMU& from, DdsImuState& to) noexcept {
  std::memcpy(to.quaternion, from.quaternion.data(), sizeof(to.quaternion));
  std::memcpy(to.gyroscope, from.gyroscope.data(), sizeof(to.gyroscope));
  std::memcpy(to.accelerometer, from.accelerometer.data(), sizeof(to.accelerometer));
  std::memcpy(to.rpy, from.rpy.data(), sizeof(to.rpy));
  to.temperature = byte_of(from.temperature);
}

// @param knows_modes false: the sender does not fill the modes, so servo mode is assumed
void read_motor(const DdsMotorState& from, DdsRobot robot, bool knows_modes,
                MotorState& to) noexcept {
  to.mode = from.mode == servo_mode(robot) || !knows_modes ? kModeServo : from.mode;
  to.q = from.q;
  to.dq = from.dq;
  to.ddq = from.ddq;
  to.tauEst = from.tau_est;
  to.q_raw = from.q_raw;
  to.dq_raw = from.dq_raw;
  to.ddq_raw = from.ddq_raw;
  to.temperature = temperature(from.temperature);
  std::memcpy(to.reserve.data(), from.reserve, sizeof(from.reserve));
}

void write_motor(const MotorState& from, DdsRobot robot, DdsMotorState& to) noexcept {
  to.mode = from.mode == kModeServo ? servo_mode(robot) : from.mode;
  to.q = from.q;
  to.dq = from.dq;
  to.ddq = from.ddq;
  to.tau_est = from.tauEst;
  to.q_raw = from.q_raw;
  to.dq_raw = from.dq_raw;
  to.ddq_raw = from.ddq_raw;
  to.temperature = byte_of(from.temperature);
  std::memcpy(to.reserve, from.reserve.data(), sizeof(to.reserve));
}

void read_battery(const DdsBmsState& from, BmsState& to) noexcept {
  to.version_h = from.version_high;
  to.version_l = from.version_low;
  to.bms_status = from.status;
  to.SOC = from.soc;
  to.current = from.current;
  to.cycle = from.cycle;
  for (int k = 0; k < 2; ++k) {
    to.BQ_NTC[k] = temperature(from.bq_ntc[k]);
    to.MCU_NTC[k] = temperature(from.mcu_ntc[k]);
  }
  std::memcpy(to.cell_vol.data(), from.cell_vol, sizeof(to.cell_vol));
}

void write_battery(const BmsState& from, DdsBmsState& to) noexcept {
  to.version_high = from.version_h;
  to.version_low = from.version_l;
  to.status = from.bms_status;
  to.soc = from.SOC;
  to.current = from.current;
  to.cycle = from.cycle;
  for (int k = 0; k < 2; ++k) {
    to.bq_ntc[k] = byte_of(from.BQ_NTC[k]);
    to.mcu_ntc[k] = byte_of(from.MCU_NTC[k]);
  }
  std::memcpy(to.cell_vol, from.cell_vol.data(), sizeof(from.cell_vol));
}

}  // namespace

bool has_head(const DdsLowState& wire) noexcept { return wire.head[0] != 0 || wire.head[1] != 0; }

FrameReport from_dds(const DdsLowState& wire, DdsRobot robot, CrcRule crc, LowState& out) noexcept {
  FrameReport report = check_wire(wire, crc);
  check_floats(wire, report);
  if (!is_usable(report.status)) return report;
  LowState state = init_low_state();
  state.frameReserve = wire.frame_reserve;
  std::memcpy(state.SN.data(), wire.sn, sizeof(wire.sn));
  std::memcpy(state.version.data(), wire.version, sizeof(wire.version));
  state.bandWidth = wire.bandwidth;
  read_imu(wire.imu_state, state.imu);
  for (int i = 0; i < kMotorSlots; ++i) {
    read_motor(wire.motor_state[i], robot, has_head(wire), state.motorState[i]);
  }
  read_battery(wire.bms_state, state.bms);
  std::memcpy(state.footForce.data(), wire.foot_force, sizeof(wire.foot_force));
  std::memcpy(state.footForceEst.data(), wire.foot_force_est, sizeof(wire.foot_force_est));
  state.tick = wire.tick;
  std::memcpy(state.wirelessRemote.data(), wire.wireless_remote, sizeof(wire.wireless_remote));
  state.reserve = wire.reserve;
  state.crc = wire.crc;
  out = state;
  return report;
}

FrameReport to_dds(const LowState& state, DdsRobot robot, DdsLowState& out) noexcept {
  DdsLowState wire;
  std::memset(&wire, 0, sizeof(wire));
  wire.head[0] = 0xFE;
  wire.head[1] = 0xEF;
  wire.level_flag = LOWLEVEL;
  wire.frame_reserve = state.frameReserve;
  std::memcpy(wire.sn, state.SN.data(), sizeof(wire.sn));
  std::memcpy(wire.version, state.version.data(), sizeof(wire.version));
  wire.bandwidth = state.bandWidth;
  write_imu(state.imu, wire.imu_state);
  for (int i = 0; i < kMotorSlots; ++i) {
    write_motor(state.motorState[i], robot, wire.motor_state[i]);
  }
  write_battery(state.bms, wire.bms_state);
  std::memcpy(wire.foot_force, state.footForce.data(), sizeof(wire.foot_force));
  std::memcpy(wire.foot_force_est, state.footForceEst.data(), sizeof(wire.foot_force_est));
  wire.tick = state.tick;
  std::memcpy(wire.wireless_remote, state.wirelessRemote.data(), sizeof(wire.wireless_remote));
  wire.reserve = state.reserve;
  FrameReport report;
  report.size = sizeof(wire);
  check_floats(wire, report);
  if (!is_usable(report.status)) return report;
  wire.crc = wire_crc(wire);
  std::memcpy(&out, &wire, sizeof(wire));
  return report;
}

}  // namespace surefoot
