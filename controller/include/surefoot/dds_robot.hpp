// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Robot that speaks unitree_sdk2's low level over DDS. Both have the same topics and types, but
/// different motor modes.
enum class DdsRobot {
  kGo2,  ///< "go2": servo mode 0x01
  kB2    ///< "b2": servo mode 0x0A
};
/// Return the name of a robot, such as "go2". Real-time: yes.
const char* to_string(DdsRobot robot) noexcept;

/// Return the robot with this name. Throws surefoot::Error if the name is unknown; the message
/// lists the valid names.
DdsRobot to_dds_robot(const std::string& name);

/// What a missing CRC means. A wrong CRC other than 0 is refused in any case.
enum class CrcRule {
  kZeroIsAbsent,  ///< crc 0: the sender computes no CRC, as unitree_mujoco's Python simulator
  kRequired       ///< crc 0 is refused as a wrong CRC
};

}  // namespace surefoot
