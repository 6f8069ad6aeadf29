// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/frames.hpp"

namespace surefoot {

namespace {

constexpr std::uint32_t kPolynomial = 0x04C11DB7;  // CRC-32 of IEEE 802.3, as in unitree_legged_sdk

struct Table {
  std::array<std::uint32_t, 256> entry{};
  constexpr Table() {
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
      std::uint32_t crc = byte << 24;
      for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ (crc & 0x80000000 ? kPolynomial : 0);
      entry[byte] = crc;
    }
  }
};
constexpr Table kTable;

}  // namespace

std::uint32_t crc32(const std::uint8_t* data, std::size_t size) noexcept {
  std::uint32_t crc = 0xFFFFFFFF;
  for (std::size_t word = 0; word + 4 <= size; word += 4) {
    for (int byte = 3; byte >= 0; --byte) {
      crc = (crc << 8) ^ kTable.entry[(crc >> 24) ^ data[word + byte]];
    }
  }
  return crc;
}

}  // namespace surefoot
