// SPDX-License-Identifier: BSD-3-Clause
#include "dds/wire/wire_crc.hpp"

#include <array>
#include <cstring>

#include "surefoot/frames.hpp"

namespace surefoot {

namespace {

using Byte = std::uint8_t;

// Clear the bytes from `begin` up to `end`.
void clear(Byte* image, std::size_t begin, std::size_t end) noexcept {
  std::memset(image + begin, 0, end - begin);
}

void clear_padding(Byte* image, const DdsLowCmd&) noexcept {
  clear(image, offsetof(DdsLowCmd, bandwidth) + 2, offsetof(DdsLowCmd, motor_cmd));
  for (std::size_t i = 0; i < 20; ++i) {
    const std::size_t motor = offsetof(DdsLowCmd, motor_cmd) + i * sizeof(DdsMotorCmd);
    clear(image, motor + 1, motor + offsetof(DdsMotorCmd, q));
  }
  clear(image, offsetof(DdsLowCmd, gpio) + 1, offsetof(DdsLowCmd, reserve));
}

void clear_padding(Byte* image, const DdsLowState&) noexcept {
  clear(image, offsetof(DdsLowState, bandwidth) + 2, offsetof(DdsLowState, imu_state));
  clear(image, offsetof(DdsLowState, imu_state) + offsetof(DdsImuState, temperature) + 1,
        offsetof(DdsLowState, motor_state));
  for (std::size_t i = 0; i < 20; ++i) {
    const std::size_t motor = offsetof(DdsLowState, motor_state) + i * sizeof(DdsMotorState);
    clear(image, motor + 1, motor + offsetof(DdsMotorState, q));
    clear(image, motor + offsetof(DdsMotorState, temperature) + 1,
          motor + offsetof(DdsMotorState, lost));
  }
  clear(image, offsetof(DdsLowState, bit_flag) + 1, offsetof(DdsLowState, adc_reel));
  clear(image, offsetof(DdsLowState, temperature_ntc2) + 1, offsetof(DdsLowState, power_v));
}

template <typename Wire>
std::uint32_t crc_of(const Wire& message) noexcept {
  std::array<Byte, sizeof(Wire)> image;
  std::memcpy(image.data(), &message, image.size());
  clear_padding(image.data(), message);
  return crc32(image.data(), offsetof(Wire, crc));
}

}  // namespace

std::uint32_t wire_crc(const DdsLowCmd& cmd) noexcept { return crc_of(cmd); }
std::uint32_t wire_crc(const DdsLowState& state) noexcept { return crc_of(state); }

}  // namespace surefoot
