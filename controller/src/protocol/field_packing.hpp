// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "protocol/frame_layout.hpp"

namespace surefoot {

/// Write all fields of a struct to the wire. Real-time: yes.
/// @param base LowCmd or LowState
/// @param wire out, layout.size - 4 bytes
/// @param report out, the first value that is not finite, else the first out of range
void pack(const FrameLayout& layout, const std::uint8_t* base, const FrameExtras& extras,
          std::uint8_t* wire, FrameReport& report) noexcept;

/// Read all fields from the wire; `report` gets the first value that is not finite. Real-time: yes.
void unpack(const FrameLayout& layout, const std::uint8_t* wire, std::uint8_t* base,
            FrameExtras& extras, FrameReport& report) noexcept;

}  // namespace surefoot
