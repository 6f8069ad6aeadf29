// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace surefoot {

/// Buttons of the remote, as bits of WirelessRemote::buttons.
enum class Button : std::uint16_t {
  kR1 = 1U << 0,
  kL1 = 1U << 1,
  kStart = 1U << 2,
  kSelect = 1U << 3,
  kR2 = 1U << 4,
  kL2 = 1U << 5,
  kF1 = 1U << 6,
  kF2 = 1U << 7,
  kA = 1U << 8,
  kB = 1U << 9,
  kX = 1U << 10,
  kY = 1U << 11,
  kUp = 1U << 12,
  kRight = 1U << 13,
  kDown = 1U << 14,
  kLeft = 1U << 15
};

/// What the 40 bytes of LowState::wirelessRemote say (the SDK's joystick.h).
struct WirelessRemote {
  std::uint16_t buttons = 0;
  float lx = 0.0F;  ///< -1 .. 1, left stick, right
  float ly = 0.0F;  ///< -1 .. 1, left stick, up
  float rx = 0.0F;  ///< -1 .. 1, right stick, right
  float ry = 0.0F;  ///< -1 .. 1, right stick, up
  float L2 = 0.0F;  ///< 0 .. 1, trigger

  bool pressed(Button button) const noexcept {
    return (buttons & static_cast<std::uint16_t>(button)) != 0;
  }
};

/// Read the remote. All zero is a remote at rest, or none; a stick that is not finite or beyond its
/// range by more than a little puts all sticks at rest. Buttons count nevertheless: a button may be
/// what damps the robot. Real-time: yes.
WirelessRemote decode_wireless_remote(const std::array<std::uint8_t, 40>& bytes) noexcept;

/// Write the remote; the head and the idle bytes are zero. Real-time: yes.
std::array<std::uint8_t, 40> encode_wireless_remote(const WirelessRemote& remote) noexcept;

}  // namespace surefoot
