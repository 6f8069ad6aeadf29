// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "surefoot/low_level.hpp"

namespace surefoot {

/// Family of SDK releases and robots that share one frame format on the wire.
///
/// Frames are shorter than the structs: torques and gains are transmitted as 16-bit fixed point. No
/// generation can decode the frames of another.
enum class Generation {
  kA1v33,   ///< "a1-v3.3": SDK v3.2 - v3.3.4, Aliengo; LowCmd 610 bytes, LowState 771 bytes
  kGo1v34,  ///< "go1-v3.4": SDK v3.3.2 and v3.4.2; 602 and 795 bytes
  kGo1v38,  ///< "go1-v3.8": SDK v3.5 - v3.8.0, branch go1; 614 and 807 bytes
  kB1v38    ///< "b1-v3.8": SDK v3.8.1, v3.8.3, branch B1; 614 and 839 bytes
};
constexpr int kGenerations = 4;
/// Return the name of a generation, such as "go1-v3.8". Real-time: yes.
const char* to_string(Generation generation) noexcept;

/// Return the generation with this name; throws surefoot::Error with the valid names.
Generation to_generation(const std::string& name);

/// Colour of one of the four lights of an A1.
struct LED {
  std::uint8_t r, g, b;
};

/// Fields of some generations that LowCmd and LowState do not have. Surefoot only passes them on.
struct FrameExtras {
  std::uint16_t commVersion = 0;  ///< a1-v3.3, go1-v3.4
  std::uint16_t robotID = 0;      ///< a1-v3.3, go1-v3.4
  std::array<LED, 4> led{};       ///< a1-v3.3, LowCmd only
  // b1-v3.8, LowState only: continues the arrays of BmsState, which hold 2, 2 and 10 values.
  std::array<std::int8_t, 6> BQ_NTC{};       ///< [deg C] sensors 2 .. 7
  std::array<std::int8_t, 6> MCU_NTC{};      ///< [deg C] sensors 2 .. 7
  std::array<std::uint16_t, 20> cell_vol{};  ///< [mV] cells 10 .. 29
};

/// Result of encoding or decoding a frame. Refused: the output keeps its old value.
enum class FrameStatus {
  kOk,
  kSaturated,        ///< encoded; values out of range were set to their limits
  kNotFinite,        ///< refused: a number is NaN or infinite
  kWrongLength,      ///< refused: no generation has frames of this length
  kWrongGeneration,  ///< refused: the length is that of another generation's frame
  kBlank,            ///< refused: all bytes are zero, as the SDK sends before its first SetSend
  kWrongHead,        ///< refused: the frame does not begin with FE EF
  kWrongLevel,       ///< refused: levelFlag is not LOWLEVEL
  kWrongCrc          ///< refused: the CRC does not match
};
/// Return whether the encoding gave a frame, or the decoding gave a struct. Real-time: yes.
constexpr bool is_usable(FrameStatus status) noexcept {
  return status == FrameStatus::kOk || status == FrameStatus::kSaturated;
}
/// Return the status in words, such as "wrong crc". Real-time: yes.
const char* to_string(FrameStatus status) noexcept;

/// Result of encoding or decoding a frame, and the first problem found.
struct FrameReport {
  FrameStatus status = FrameStatus::kOk;
  const char* field = "";  ///< first field that is not finite, else first field out of range
  int motor = -1;          ///< SDK number of the motor that the field belongs to, or -1
  std::size_t size = 0;    ///< [bytes] length of the frame
  Generation expected = Generation::kGo1v38;
  Generation detected = Generation::kGo1v38;  ///< by the length of the frame; see kWrongGeneration
};
/// Describe the result in a sentence. Real-time: no.
std::string to_text(const FrameReport& report);

constexpr std::size_t kMaxFrameSize = 839;  ///< [bytes] LowState of b1-v3.8

/// One datagram; `size` is 0 before the first encoding.
struct Frame {
  std::array<std::uint8_t, kMaxFrameSize> bytes{};
  std::size_t size = 0;
};

/// Return the length [bytes] of a LowCmd frame on the wire. Real-time: yes.
std::size_t low_cmd_size(Generation generation) noexcept;
/// Return the length [bytes] of a LowState frame on the wire. Real-time: yes.
std::size_t low_state_size(Generation generation) noexcept;

/// Encode a command as a frame on the wire, CRC included. Real-time: yes.
///
/// tau is truncated to multiples of 1/256 N.m (b1-v3.8: 1/128), Kp to multiples of 1/32, Kd to
/// multiples of 1/16. Where the vendor's code wraps around (128 N.m becomes -128 N.m), values
/// saturate and the result is kSaturated. If a number is not finite, the frame is refused and `out`
/// keeps its old value. The crc in `cmd` is ignored.
FrameReport encode_low_cmd(const LowCmd& cmd, const FrameExtras& extras, Generation generation,
                           Frame& out) noexcept;
/// Encode a LowState as a frame. Real-time: yes. tauEst is truncated as tau is, ddq to whole
/// rad/s^2, cell voltages to multiples of 32 mV.
FrameReport encode_low_state(const LowState& state, const FrameExtras& extras,
                             Generation generation, Frame& out) noexcept;

/// Decode a frame; `cmd` and `extras` change only if the whole frame is valid. Real-time: yes.
FrameReport decode_low_cmd(const std::uint8_t* data, std::size_t size, Generation generation,
                           LowCmd& cmd, FrameExtras& extras) noexcept;
/// Decode a LowState. footForceEst is decoded too, although the vendor's A1 client ignores it.
/// `state` and `extras` change only if the whole frame is valid. Real-time: yes.
FrameReport decode_low_state(const std::uint8_t* data, std::size_t size, Generation generation,
                             LowState& state, FrameExtras& extras) noexcept;

/// Compute the CRC-32 of the wire format: polynomial 0x04C11DB7, initial value 0xFFFFFFFF, neither
/// input nor output reflected. The data are little-endian 32-bit words, processed most significant
/// bit first. Bytes after the last whole word are ignored. Real-time: yes.
std::uint32_t crc32(const std::uint8_t* data, std::size_t size) noexcept;

}  // namespace surefoot
