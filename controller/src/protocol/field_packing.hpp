// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "protocol/frame_layout.hpp"

namespace surefoot {

/// Write all fields of a struct to the wire; the report says what did not fit. Real-time: yes.
/// @param base LowCmd or LowState @param wire layout.size - 4 bytes
void pack(const FrameLayout& layout, const std::uint8_t* base, const FrameExtras& extras,
          std::uint8_t* wire, FrameReport& report) noexcept;

/// Read all fields from the wire; the report says what was not finite. Real-time: yes.
void unpack(const FrameLayout& layout, const std::uint8_t* wire, std::uint8_t* base,
            FrameExtras& extras, FrameReport& report) noexcept;

}  // namespace surefoot
