// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "dds/wire/wire_crc.hpp"
#include "surefoot/dds_robot.hpp"
#include "surefoot/frames.hpp"

namespace surefoot {

/// Record kNotFinite for a value that is NaN or infinite, unless a problem is recorded already.
/// Real-time: yes.
/// @param motor SDK number of the motor, or -1
inline void check_finite(float value, const char* field, int motor, FrameReport& report) noexcept {
  if (std::isfinite(value) || report.status != FrameStatus::kOk) return;
  report.status = FrameStatus::kNotFinite;
  report.field = field;
  report.motor = motor;
}

/// Check the CRC of a message, and that not all of its bytes are zero. Real-time: yes.
/// @return kOk, kBlank or kWrongCrc
template <typename Wire>
FrameReport check_wire(const Wire& wire, CrcRule rule) noexcept {
  FrameReport report;
  report.size = sizeof(Wire);
  std::array<std::uint8_t, sizeof(Wire)> bytes;
  std::memcpy(bytes.data(), &wire, bytes.size());
  const bool blank =
      std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte == 0; });
  const bool absent = wire.crc == 0 && rule == CrcRule::kZeroIsAbsent;
  if (blank) {
    report.status = FrameStatus::kBlank;
  } else if (!absent && wire.crc != wire_crc(wire)) {
    report.status = FrameStatus::kWrongCrc;
  }
  return report;
}

}  // namespace surefoot
