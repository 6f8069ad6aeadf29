// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "dds/generated/unitree_go.h"

namespace surefoot {

/// C structs of the DDS types of Go2 and B2, in natural alignment.
///
/// The CRC covers these structs. The payload on the wire has other offsets, because CDR aligns the
/// first motor differently: 808 bytes of LowCmd, 1176 bytes of LowState.
using DdsLowCmd = unitree_go_msg_dds__LowCmd_;
using DdsMotorCmd = unitree_go_msg_dds__MotorCmd_;
using DdsLowState = unitree_go_msg_dds__LowState_;
using DdsMotorState = unitree_go_msg_dds__MotorState_;
using DdsImuState = unitree_go_msg_dds__IMUState_;
using DdsBmsState = unitree_go_msg_dds__BmsState_;

static_assert(sizeof(DdsLowCmd) == 812 && sizeof(DdsLowState) == 1180);
static_assert(sizeof(DdsMotorCmd) == 36 && sizeof(DdsMotorState) == 48);
static_assert(offsetof(DdsLowCmd, sn) == 4 && offsetof(DdsLowCmd, version) == 12);
static_assert(offsetof(DdsLowCmd, bandwidth) == 20 && offsetof(DdsLowCmd, motor_cmd) == 24);
static_assert(offsetof(DdsMotorCmd, q) == 4 && offsetof(DdsMotorCmd, dq) == 8);
static_assert(offsetof(DdsMotorCmd, tau) == 12 && offsetof(DdsMotorCmd, kp) == 16);
static_assert(offsetof(DdsMotorCmd, kd) == 20 && offsetof(DdsMotorCmd, reserve) == 24);
static_assert(offsetof(DdsLowCmd, bms_cmd) == 744 && offsetof(DdsLowCmd, wireless_remote) == 748);
static_assert(offsetof(DdsLowCmd, led) == 788 && offsetof(DdsLowCmd, fan) == 800);
static_assert(offsetof(DdsLowCmd, gpio) == 802 && offsetof(DdsLowCmd, reserve) == 804);
static_assert(offsetof(DdsLowCmd, crc) == 808);

static_assert(offsetof(DdsLowState, imu_state) == 24 && offsetof(DdsImuState, gyroscope) == 16);
static_assert(offsetof(DdsImuState, accelerometer) == 28 && offsetof(DdsImuState, rpy) == 40);
static_assert(offsetof(DdsImuState, temperature) == 52);
static_assert(offsetof(DdsLowState, motor_state) == 80 && offsetof(DdsMotorState, q) == 4);
static_assert(offsetof(DdsMotorState, temperature) == 32 && offsetof(DdsMotorState, lost) == 36);
static_assert(offsetof(DdsLowState, bms_state) == 1040 && offsetof(DdsBmsState, soc) == 3);
static_assert(offsetof(DdsBmsState, current) == 4 && offsetof(DdsBmsState, cycle) == 8);
static_assert(offsetof(DdsBmsState, bq_ntc) == 10 && offsetof(DdsBmsState, mcu_ntc) == 12);
static_assert(offsetof(DdsBmsState, cell_vol) == 14);
static_assert(offsetof(DdsLowState, foot_force) == 1084 && offsetof(DdsLowState, tick) == 1100);
static_assert(offsetof(DdsLowState, foot_force_est) == 1092);
static_assert(offsetof(DdsLowState, wireless_remote) == 1104);
static_assert(offsetof(DdsLowState, bit_flag) == 1144 && offsetof(DdsLowState, adc_reel) == 1148);
static_assert(offsetof(DdsLowState, temperature_ntc1) == 1152);
static_assert(offsetof(DdsLowState, temperature_ntc2) == 1153);
static_assert(offsetof(DdsLowState, power_v) == 1156 && offsetof(DdsLowState, power_a) == 1160);
static_assert(offsetof(DdsLowState, fan_frequency) == 1164);
static_assert(offsetof(DdsLowState, reserve) == 1172 && offsetof(DdsLowState, crc) == 1176);

}  // namespace surefoot
