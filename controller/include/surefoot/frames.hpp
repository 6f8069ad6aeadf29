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
  kGo1v34,  ///< "go1-v3.4": SDK v3.3.2 and v3.4.2; LowCmd 602 bytes, LowState 795 bytes
  kGo1v38,  ///< "go1-v3.8": SDK v3.5 - v3.8.0, branch go1; LowCmd 614, LowState 807 bytes
  kB1v38    ///< "b1-v3.8": SDK v3.8.1, v3.8.3, branch B1; LowCmd 614, LowState 839 bytes
};
constexpr int kGenerations = 4;  ///< number of generations
/// Return the name of a generation, such as "go1-v3.8". Real-time: yes.
const char* to_string(Generation generation) noexcept;

/// Return the generation with this name. Throws surefoot::Error if the name is unknown; the message
/// lists the valid names.
Generation to_generation(const std::string& name);

/// Colour of one of the four lights of an A1, 0 .. 255 per component.
struct LED {
  std::uint8_t r,  ///< red
      g,           ///< green
      b;           ///< blue
};

/// Fields that some frame formats have but LowCmd and LowState do not. Surefoot only passes them
/// on.
struct FrameExtras {
  std::uint16_t commVersion = 0;  ///< communication version; a1-v3.3 and go1-v3.4 only
  std::uint16_t robotID = 0;      ///< robot number; a1-v3.3 and go1-v3.4 only
  std::array<LED, 4> led{};       ///< four lights; LowCmd of a1-v3.3 only
  // LowState of b1-v3.8 only. These fields continue the arrays of BmsState.
  std::array<std::int8_t, 6> BQ_NTC{};       ///< [deg C] elements 2 .. 7 of BQ_NTC
  std::array<std::int8_t, 6> MCU_NTC{};      ///< [deg C] elements 2 .. 7 of MCU_NTC
  std::array<std::uint16_t, 20> cell_vol{};  ///< [mV] voltages of battery cells 10 .. 29
};

/// Result of encoding or decoding a frame. If the frame is refused, the output keeps its old value.
enum class FrameStatus {
  kOk,               ///< encoded, or decoded, without changes to the values
  kSaturated,        ///< encoded; values out of range were set to their limits
  kNotFinite,        ///< refused: a number is NaN or infinite
  kWrongLength,      ///< refused: no generation has frames of this length
  kWrongGeneration,  ///< refused: frames of another generation have this length
  kBlank,            ///< refused: all bytes are zero, as the SDK sends before its first SetSend
  kWrongHead,        ///< refused: the frame does not begin with FE EF
  kWrongLevel,       ///< refused: levelFlag is not LOWLEVEL
  kWrongCrc          ///< refused: the CRC does not match
};
/// Return whether the encoder wrote a frame, or the decoder wrote a struct. Real-time: yes.
constexpr bool is_usable(FrameStatus status) noexcept {
  return status == FrameStatus::kOk || status == FrameStatus::kSaturated;
}
/// Return the status in words, such as "wrong crc". Real-time: yes.
const char* to_string(FrameStatus status) noexcept;

/// Result of encoding or decoding a frame, and the first problem found.
struct FrameReport {
  FrameStatus status = FrameStatus::kOk;  ///< result
  const char* field = "";  ///< first field that is not finite, else first field out of range
  int motor = -1;          ///< SDK number of the motor that the field belongs to, or -1
  std::size_t size = 0;    ///< [bytes] length of the frame
  Generation expected = Generation::kGo1v38;  ///< generation that the caller passed
  Generation detected = Generation::kGo1v38;  ///< generation with frames of this length
  std::size_t expected_size = 0;              ///< [bytes] length of a frame of `expected`
};
/// Describe the result in a sentence. Real-time: no.
std::string to_text(const FrameReport& report);

constexpr std::size_t kMaxFrameSize = 839;  ///< [bytes] longest frame: LowState of b1-v3.8

/// Frame on the wire, the content of one datagram.
struct Frame {
  std::array<std::uint8_t, kMaxFrameSize> bytes{};  ///< the first `size` bytes are the frame
  std::size_t size = 0;  ///< [bytes] length of the frame; 0 before the first encoding
};

/// Return the length [bytes] of a LowCmd frame on the wire. Real-time: yes.
std::size_t low_cmd_size(Generation generation) noexcept;
/// Return the length [bytes] of a LowState frame on the wire. Real-time: yes.
std::size_t low_state_size(Generation generation) noexcept;

/// Encode a command as a frame on the wire, CRC included. Real-time: yes.
///
/// tau is truncated to multiples of 1/256 N.m (b1-v3.8: 1/128), Kp to multiples of 1/32, Kd to
/// multiples of 1/16. Where the vendor's code wraps around (128 N.m becomes -128 N.m), values
/// saturate, and the result is kSaturated. If a number is not finite, the frame is refused and
/// `out` keeps its old value. The crc in `cmd` is ignored.
FrameReport encode_low_cmd(const LowCmd& cmd, const FrameExtras& extras, Generation generation,
                           Frame& out) noexcept;
/// Encode a LowState as a frame on the wire, CRC included. Real-time: yes.
///
/// tauEst is truncated like tau of encode_low_cmd(), ddq to whole rad/s^2, and cell voltages to
/// multiples of 32 mV.
FrameReport encode_low_state(const LowState& state, const FrameExtras& extras,
                             Generation generation, Frame& out) noexcept;

/// Decode a LowCmd frame of `size` bytes. `cmd` and `extras` change only if the whole frame is
/// valid. Real-time: yes.
FrameReport decode_low_cmd(const std::uint8_t* data, std::size_t size, Generation generation,
                           LowCmd& cmd, FrameExtras& extras) noexcept;
/// Decode a LowState frame of `size` bytes. `state` and `extras` change only if the whole frame is
/// valid. footForceEst is decoded too, although the vendor's A1 client ignores this field.
/// Real-time: yes.
FrameReport decode_low_state(const std::uint8_t* data, std::size_t size, Generation generation,
                             LowState& state, FrameExtras& extras) noexcept;

/// Compute the CRC-32 of the wire format: polynomial 0x04C11DB7, initial value 0xFFFFFFFF, neither
/// input nor output reflected. The data are little-endian 32-bit words, processed most significant
/// bit first. Bytes after the last whole word are ignored. Real-time: yes.
std::uint32_t crc32(const std::uint8_t* data, std::size_t size) noexcept;

}  // namespace surefoot
