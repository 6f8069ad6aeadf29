// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "protocol/frame_layout.hpp"

namespace surefoot {

/// Write all fields of a struct to a frame. Real-time: yes.
/// @param base the struct, LowCmd or LowState
/// @param wire out: the frame without its CRC, layout.size - 4 bytes
/// @param report out: the first value that is not finite; without such a value, the first value
///   that is out of range
void pack(const FrameLayout& layout, const std::uint8_t* base, const FrameExtras& extras,
          std::uint8_t* wire, FrameReport& report) noexcept;

/// Read all fields from a frame; `report` gets the first value that is not finite. Real-time: yes.
void unpack(const FrameLayout& layout, const std::uint8_t* wire, std::uint8_t* base,
            FrameExtras& extras, FrameReport& report) noexcept;

}  // namespace surefoot
