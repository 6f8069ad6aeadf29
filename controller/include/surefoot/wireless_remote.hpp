// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

namespace surefoot {

/// Buttons of the remote, as bits of WirelessRemote::buttons.
enum class Button : std::uint16_t {
  kR1 = 1U << 0,      ///< bit 0
  kL1 = 1U << 1,      ///< bit 1
  kStart = 1U << 2,   ///< bit 2
  kSelect = 1U << 3,  ///< bit 3
  kR2 = 1U << 4,      ///< bit 4
  kL2 = 1U << 5,      ///< bit 5
  kF1 = 1U << 6,      ///< bit 6
  kF2 = 1U << 7,      ///< bit 7
  kA = 1U << 8,       ///< bit 8
  kB = 1U << 9,       ///< bit 9
  kX = 1U << 10,      ///< bit 10
  kY = 1U << 11,      ///< bit 11
  kUp = 1U << 12,     ///< bit 12
  kRight = 1U << 13,  ///< bit 13
  kDown = 1U << 14,   ///< bit 14
  kLeft = 1U << 15    ///< bit 15
};

/// Buttons and sticks in the 40 bytes of LowState::wirelessRemote. The layout is that of the SDK's
/// joystick.h.
struct WirelessRemote {
  std::uint16_t buttons = 0;  ///< one bit per button, see Button
  float lx = 0.0F;            ///< left stick, positive to the right: -1 .. 1
  float ly = 0.0F;            ///< left stick, positive up: -1 .. 1
  float rx = 0.0F;            ///< right stick, positive to the right: -1 .. 1
  float ry = 0.0F;            ///< right stick, positive up: -1 .. 1
  float L2 = 0.0F;            ///< position of the trigger L2: 0 .. 1; its button is Button::kL2

  /// Return whether a button is pressed. Real-time: yes.
  bool pressed(Button button) const noexcept {
    return (buttons & static_cast<std::uint16_t>(button)) != 0;
  }
};

/// Decode the 40 bytes of LowState::wirelessRemote. All bytes are zero if the remote is at rest or
/// missing. If the value of a stick or of the trigger L2 is not finite or above 1.05 in magnitude,
/// all sticks and the trigger are set to 0.
/// Buttons are decoded in any case, because a button may damp the robot. Real-time: yes.
WirelessRemote decode_wireless_remote(const std::array<std::uint8_t, 40>& bytes) noexcept;

/// Encode the remote as 40 bytes; head and unused bytes are zero. Real-time: yes.
std::array<std::uint8_t, 40> encode_wireless_remote(const WirelessRemote& remote) noexcept;

}  // namespace surefoot
