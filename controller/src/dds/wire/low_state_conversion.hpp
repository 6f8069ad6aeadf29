// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dds/wire/wire_types.hpp"
#include "surefoot/dds_robot.hpp"
#include "surefoot/frames.hpp"

namespace surefoot {

/// Return whether a LowState has a head. unitree_mujoco leaves it 0, and does not fill the motor
/// modes either. Real-time: yes.
bool has_head(const DdsLowState& wire) noexcept;

/// Convert a LowState from the DDS type. Real-time: yes.
///
/// The servo mode of the robot becomes kModeServo; other motor modes keep their value. Without a
/// head all modes become kModeServo. Temperatures
/// of 128 .. 199 deg C become 127, because the SDK's fields are signed; bytes from 200 on are
/// negative temperatures. Of the battery cells the first 10 are kept. The result is kBlank,
/// kWrongCrc or kNotFinite if the LowState is refused; `out` then keeps its old value.
FrameReport from_dds(const DdsLowState& wire, DdsRobot robot, CrcRule crc, LowState& out) noexcept;

/// Convert a LowState to the DDS type, CRC included, as a robot sends it. Real-time: yes.
///
/// Fields that the SDK's LowState does not have are 0. Negative temperatures keep their bytes. If a
/// number is not finite, the result is kNotFinite, and `out` keeps its old value.
FrameReport to_dds(const LowState& state, DdsRobot robot, DdsLowState& out) noexcept;

}  // namespace surefoot
