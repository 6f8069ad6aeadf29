// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/wireless_remote.hpp"

#include <cmath>
#include <cstring>

namespace surefoot {

namespace {

// Largest valid magnitude of a stick or of the trigger L2, which kSticks includes. Chosen 5 %
// larger than 1, because the calibration of sticks is not exact. Larger values do not come from a
// stick.
constexpr float kMaxStickValue = 1.05F;

struct Stick {
  std::size_t offset;
  float WirelessRemote::* value;
};
// [bytes] Offset of the buttons; the offsets of the sticks follow.
constexpr std::size_t kButtonsOffset = 2;
constexpr Stick kSticks[] = {{4, &WirelessRemote::lx},
                             {8, &WirelessRemote::rx},
                             {12, &WirelessRemote::ry},
                             {16, &WirelessRemote::L2},
                             {20, &WirelessRemote::ly}};

}  // namespace

WirelessRemote decode_wireless_remote(const std::array<std::uint8_t, 40>& bytes) noexcept {
  WirelessRemote remote;
  std::memcpy(&remote.buttons, bytes.data() + kButtonsOffset, 2);
  bool out_of_range = false;
  for (const Stick& stick : kSticks) {
    float& value = remote.*stick.value;
    std::memcpy(&value, bytes.data() + stick.offset, 4);
    out_of_range |= !(std::abs(value) <= kMaxStickValue);
  }
  if (out_of_range) {
    for (const Stick& stick : kSticks) remote.*stick.value = 0.0F;
  }
  return remote;
}

std::array<std::uint8_t, 40> encode_wireless_remote(const WirelessRemote& remote) noexcept {
  std::array<std::uint8_t, 40> bytes{};
  std::memcpy(bytes.data() + kButtonsOffset, &remote.buttons, 2);
  for (const Stick& stick : kSticks) {
    std::memcpy(bytes.data() + stick.offset, &(remote.*stick.value), 4);
  }
  return bytes;
}

}  // namespace surefoot
