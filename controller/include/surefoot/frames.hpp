// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "surefoot/low_level.hpp"

namespace surefoot {

/// A family of SDK releases and robots that put the same frames on the wire. Frames are shorter
/// than the structs: torques and gains travel as 16-bit fixed point. No two generations understand
/// each other.
enum class Generation {
  kA1v33,   ///< "a1-v3.3": SDK v3.2 - v3.3.4 and Aliengo's; LowCmd 610 bytes, LowState 771
  kGo1v34,  ///< "go1-v3.4": SDK v3.3.2 and 3.4.2; 602, 795
  kGo1v38,  ///< "go1-v3.8": SDK v3.5 - v3.8.0, branch go1; 614, 807
  kB1v38    ///< "b1-v3.8": SDK v3.8.1, v3.8.3, branch B1; 614, 839
};
constexpr int kGenerations = 4;
const char* to_string(Generation generation) noexcept;

/// Throws surefoot::Error with the valid names.
Generation to_generation(const std::string& name);

/// One of the four colours an A1 shows.
struct LED {
  std::uint8_t r, g, b;
};

/// What some generations carry beyond LowCmd and LowState. It passes through.
struct FrameExtras {
  std::uint16_t commVersion = 0;  ///< a1-v3.3, go1-v3.4
  std::uint16_t robotID = 0;      ///< a1-v3.3, go1-v3.4
  std::array<LED, 4> led{};       ///< a1-v3.3, LowCmd
  // b1-v3.8, LowState: what follows BmsState's own two, two and ten.
  std::array<std::int8_t, 6> BQ_NTC{};       ///< [deg C] of sensors 2 .. 7
  std::array<std::int8_t, 6> MCU_NTC{};      ///< [deg C] of sensors 2 .. 7
  std::array<std::uint16_t, 20> cell_vol{};  ///< [mV] of cells 10 .. 29
};

enum class FrameStatus {
  kOk,
  kSaturated,        ///< encoded, with something out of range put at its limit
  kNotFinite,        ///< refused: a number that is none
  kWrongLength,      ///< refused: no generation has frames of this length
  kWrongGeneration,  ///< refused: the length of another generation's frame
  kBlank,            ///< refused: all zero, as the SDK sends before its first SetSend
  kWrongHead,        ///< refused: does not begin with FE EF
  kWrongLevel,       ///< refused: not a low-level frame
  kWrongCrc          ///< refused
};
/// Is there a frame, or a struct, to use?
constexpr bool is_usable(FrameStatus status) noexcept {
  return status == FrameStatus::kOk || status == FrameStatus::kSaturated;
}
const char* to_string(FrameStatus status) noexcept;

/// How a frame was encoded or decoded, and what was wrong.
struct FrameReport {
  FrameStatus status = FrameStatus::kOk;
  const char* field = "";  ///< that was the first not finite or out of range
  int motor = -1;          ///< whose field that is, or -1
  std::size_t size = 0;    ///< [bytes] of the frame
  Generation expected = Generation::kGo1v38;
  Generation detected = Generation::kGo1v38;  ///< when the status is kWrongGeneration
};
/// What it says, in words; not in the tick.
std::string to_text(const FrameReport& report);

constexpr std::size_t kMaxFrameSize = 839;

/// Bytes of one datagram.
struct Frame {
  std::array<std::uint8_t, kMaxFrameSize> bytes{};
  std::size_t size = 0;
};

std::size_t low_cmd_size(Generation generation) noexcept;    ///< [bytes] on the wire
std::size_t low_state_size(Generation generation) noexcept;  ///< [bytes] on the wire

/// Write a command as it travels, CRC included. Real-time: yes.
///
/// tau is truncated to 1/256 N.m (b1-v3.8: 1/128), Kp to 1/32, Kd to 1/16. Where the vendor's code
/// wraps (128 N.m becomes -128), values saturate and the report says so. A number that is not
/// finite refuses the whole frame: `out` keeps what it had. The CRC in `cmd` is not looked at.
FrameReport encode_low_cmd(const LowCmd& cmd, const FrameExtras& extras, Generation generation,
                           Frame& out) noexcept;
/// The same of a report; ddq travels in whole rad/s^2, cell voltages in 32 mV.
FrameReport encode_low_state(const LowState& state, const FrameExtras& extras,
                             Generation generation, Frame& out) noexcept;

/// Read a frame; `cmd` and `extras` change only if all of it is valid. Real-time: yes.
FrameReport decode_low_cmd(const std::uint8_t* data, std::size_t size, Generation generation,
                           LowCmd& cmd, FrameExtras& extras) noexcept;
/// The same of a report. Unlike the vendor's A1 client this one does read footForceEst.
FrameReport decode_low_state(const std::uint8_t* data, std::size_t size, Generation generation,
                             LowState& state, FrameExtras& extras) noexcept;

/// CRC-32 of the wire: polynomial 0x04C11DB7, initial value 0xFFFFFFFF, nothing reflected; the
/// words are little-endian and enter most significant bit first. Bytes beyond the last whole word
/// do not count. Real-time: yes.
std::uint32_t crc32(const std::uint8_t* data, std::size_t size) noexcept;

}  // namespace surefoot
