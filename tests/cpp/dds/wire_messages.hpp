// SPDX-License-Identifier: BSD-3-Clause
// Messages whose CRC the vendor's code has computed.
#pragma once

#include <cstdint>

#include "dds/wire/wire_types.hpp"

namespace surefoot {

/// Return the command of the vendor's InitLowCmd: all 20 motors in `mode`, both loops off.
DdsLowCmd vendor_init_command(std::uint8_t mode);
/// Return that command in mode 1 with tau = 0.5 (i + 1) (-1)^i on motors 0 .. 11.
DdsLowCmd vendor_torque_command();
/// Return a command in which every field has a value of its own.
DdsLowCmd every_field_command();

}  // namespace surefoot
