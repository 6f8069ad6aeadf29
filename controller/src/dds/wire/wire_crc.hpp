// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "dds/wire/wire_types.hpp"

namespace surefoot {

/// Compute the CRC of a command: crc32() of the C struct without its last word. The padding of the
/// struct counts as zero, whatever bytes it holds. Real-time: yes.
std::uint32_t wire_crc(const DdsLowCmd& cmd) noexcept;
/// Compute the CRC of a LowState in the same way. Real-time: yes.
std::uint32_t wire_crc(const DdsLowState& state) noexcept;

}  // namespace surefoot
