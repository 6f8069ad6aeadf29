// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/frame_layout.hpp"

namespace surefoot {

namespace {

using K = FieldKind;
using X = FrameExtras;

// Offsets in LowCmd. LowState begins with the same header.
constexpr Field kHeader22[] = {{"header", K::kBytes, 22, 0}};
constexpr Field kHeader10[] = {
    {"levelFlag", K::kBytes, 1, offsetof(LowCmd, levelFlag)},
    {"commVersion", K::kBytes, 2, offsetof(X, commVersion), true},
    {"robotID", K::kBytes, 2, offsetof(X, robotID), true},
    {"SN", K::kBytes, 4, offsetof(LowCmd, SN)},
    {"bandWidth", K::kUint16ToUint8, 1, offsetof(LowCmd, bandWidth)},
};
static_assert(offsetof(LowState, bandWidth) == offsetof(LowCmd, bandWidth));

constexpr Field kMotorCmd[] = {
    {"mode", K::kBytes, 1, offsetof(MotorCmd, mode)},
    {"q", K::kFloat, 1, offsetof(MotorCmd, q)},
    {"dq", K::kFloat, 1, offsetof(MotorCmd, dq)},
    {"tau", K::kTorque, 1, offsetof(MotorCmd, tau)},
    {"Kp", K::kStiffness, 1, offsetof(MotorCmd, Kp)},
    {"Kd", K::kDamping, 1, offsetof(MotorCmd, Kd)},
    {"reserve", K::kBytes, 12, offsetof(MotorCmd, reserve)},
};
constexpr Field kBmsAndTail[] = {
    {"bms", K::kBytes, sizeof(BmsCmd), offsetof(LowCmd, bms)},
    {"wirelessRemote", K::kBytes, 40, offsetof(LowCmd, wirelessRemote)},
    {"reserve", K::kBytes, 4, offsetof(LowCmd, reserve)},
};
constexpr Field kLedAndTail[] = {
    {"led", K::kBytes, 12, offsetof(X, led), true},
    {"wirelessRemote", K::kBytes, 40, offsetof(LowCmd, wirelessRemote)},
    {"reserve", K::kBytes, 4, offsetof(LowCmd, reserve)},
};

constexpr Field kImu[] = {
    {"imu.quaternion", K::kFloat, 4, offsetof(LowState, imu) + offsetof(IMU, quaternion)},
    {"imu.gyroscope", K::kFloat, 3, offsetof(LowState, imu) + offsetof(IMU, gyroscope)},
    {"imu.accelerometer", K::kFloat, 3, offsetof(LowState, imu) + offsetof(IMU, accelerometer)},
    {"imu.rpy", K::kFloat, 3, offsetof(LowState, imu) + offsetof(IMU, rpy)},
    {"imu.temperature", K::kBytes, 1, offsetof(LowState, imu) + offsetof(IMU, temperature)},
};
constexpr Field kMotorState[] = {
    {"mode", K::kBytes, 1, offsetof(MotorState, mode)},
    {"q", K::kFloat, 1, offsetof(MotorState, q)},
    {"dq", K::kFloat, 1, offsetof(MotorState, dq)},
    {"ddq", K::kInt16, 1, offsetof(MotorState, ddq)},
    {"tauEst", K::kTorque, 1, offsetof(MotorState, tauEst)},
    {"q_raw", K::kFloat, 1, offsetof(MotorState, q_raw)},
    {"dq_raw", K::kFloat, 1, offsetof(MotorState, dq_raw)},
    {"ddq_raw", K::kInt16, 1, offsetof(MotorState, ddq_raw)},
    {"temperature", K::kBytes, 1, offsetof(MotorState, temperature)},
    {"reserve", K::kBytes, 8, offsetof(MotorState, reserve)},
};
// In every generation that has a BmsState, its first twelve bytes are copied without conversion.
constexpr std::size_t kBmsOffset = offsetof(LowState, bms);
constexpr Field kBattery[] = {
    {"bms", K::kBytes, 14, kBmsOffset},
    {"bms.cell_vol", K::kCellVoltage, 10, kBmsOffset + offsetof(BmsState, cell_vol)},
};
constexpr Field kBatteryB1[] = {
    {"bms", K::kBytes, 12, kBmsOffset},
    {"bms.BQ_NTC", K::kBytes, 6, offsetof(X, BQ_NTC), true},
    {"bms.MCU_NTC", K::kBytes, 2, kBmsOffset + offsetof(BmsState, MCU_NTC)},
    {"bms.MCU_NTC", K::kBytes, 6, offsetof(X, MCU_NTC), true},
    {"bms.cell_vol", K::kCellVoltage, 10, kBmsOffset + offsetof(BmsState, cell_vol)},
    {"bms.cell_vol", K::kCellVoltage, 20, offsetof(X, cell_vol), true},
};
static_assert(offsetof(BmsState, BQ_NTC) == 10 && offsetof(BmsState, MCU_NTC) == 12);
constexpr Field kStateTail[] = {
    {"footForce", K::kBytes, 8, offsetof(LowState, footForce)},
    {"footForceEst", K::kBytes, 8, offsetof(LowState, footForceEst)},
    {"tick", K::kBytes, 4, offsetof(LowState, tick)},
    {"wirelessRemote", K::kBytes, 40, offsetof(LowState, wirelessRemote)},
    {"reserve", K::kBytes, 4, offsetof(LowState, reserve)},
};

template <int N>
constexpr Section single_section(const Field (&fields)[N]) {
  return {fields, N};
}

constexpr Section kMotorCmds = {kMotorCmd, 7, offsetof(LowCmd, motorCmd), sizeof(MotorCmd),
                                kMotorSlots};
constexpr Section kMotorStates = {kMotorState, 10, offsetof(LowState, motorState),
                                  sizeof(MotorState), kMotorSlots};

constexpr FrameLayout kLowCmd[kGenerations] = {
    {{single_section(kHeader10), kMotorCmds, single_section(kLedAndTail)}, 3, 610, false, 256.0},
    {{single_section(kHeader10), kMotorCmds, single_section(kBmsAndTail)}, 3, 602, false, 256.0},
    {{single_section(kHeader22), kMotorCmds, single_section(kBmsAndTail)}, 3, 614, true, 256.0},
    {{single_section(kHeader22), kMotorCmds, single_section(kBmsAndTail)}, 3, 614, true, 128.0},
};
constexpr FrameLayout kLowState[kGenerations] = {
    {{single_section(kHeader10), single_section(kImu), kMotorStates, single_section(kStateTail)},
     4,
     771,
     false,
     256.0},
    {{single_section(kHeader10), single_section(kImu), kMotorStates, single_section(kBattery),
      single_section(kStateTail)},
     5,
     795,
     false,
     256.0},
    {{single_section(kHeader22), single_section(kImu), kMotorStates, single_section(kBattery),
      single_section(kStateTail)},
     5,
     807,
     true,
     256.0},
    {{single_section(kHeader22), single_section(kImu), kMotorStates, single_section(kBatteryB1),
      single_section(kStateTail)},
     5,
     839,
     true,
     128.0},
};

constexpr std::size_t wire_size(const Field& field) {
  switch (field.kind) {
    case K::kBytes:
    case K::kCellVoltage:
    case K::kUint16ToUint8:
      return field.count;
    case K::kFloat:
      return 4 * field.count;
    default:
      return 2 * field.count;
  }
}
constexpr bool size_matches(const FrameLayout& layout) {
  std::size_t size = 4;  // the CRC
  for (int s = 0; s < layout.count; ++s) {
    const Section& section = layout.sections[s];
    for (int f = 0; f < section.count; ++f) {
      size += section.repeat * wire_size(section.fields[f]);
    }
  }
  return size == layout.size && size <= kMaxFrameSize;
}
static_assert(size_matches(kLowCmd[0]) && size_matches(kLowCmd[1]) && size_matches(kLowCmd[2]) &&
              size_matches(kLowCmd[3]));
static_assert(size_matches(kLowState[0]) && size_matches(kLowState[1]) &&
              size_matches(kLowState[2]) && size_matches(kLowState[3]));

}  // namespace

const FrameLayout& low_cmd_layout(Generation generation) noexcept {
  return kLowCmd[static_cast<int>(generation)];
}
const FrameLayout& low_state_layout(Generation generation) noexcept {
  return kLowState[static_cast<int>(generation)];
}

}  // namespace surefoot
