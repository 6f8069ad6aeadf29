// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/frames.hpp"

#include <algorithm>
#include <cstring>

#include "protocol/field_packing.hpp"

namespace surefoot {

namespace {

using LayoutFunction = const FrameLayout& (*)(Generation) noexcept;

template <typename Struct>
FrameReport encode(const FrameLayout& layout, Generation generation, Struct message,
                   const FrameExtras& extras, Frame& out) noexcept {
  FrameReport report;
  report.expected = report.detected = generation;
  report.size = report.expected_size = layout.size;
  message.head = {0xFE, 0xEF};
  if (layout.has_header) message.levelFlag = LOWLEVEL;
  Frame frame;
  frame.size = layout.size;
  pack(layout, reinterpret_cast<const std::uint8_t*>(&message), extras, frame.bytes.data(), report);
  if (!is_usable(report.status)) return report;
  const std::uint32_t crc = crc32(frame.bytes.data(), layout.size - 4);
  std::memcpy(frame.bytes.data() + layout.size - 4, &crc, 4);
  out = frame;
  return report;
}

// Check the length of a frame. If it is not as expected, find the generation whose frames have this
// length.
FrameStatus check_length(std::size_t size, LayoutFunction layout_of, FrameReport& report) noexcept {
  if (layout_of(report.expected).size == size) return FrameStatus::kOk;
  for (int g = 0; g < kGenerations; ++g) {
    if (layout_of(static_cast<Generation>(g)).size == size) {
      report.detected = static_cast<Generation>(g);
      return FrameStatus::kWrongGeneration;
    }
  }
  return FrameStatus::kWrongLength;
}

FrameStatus check_header_and_crc(const FrameLayout& layout, const std::uint8_t* data) noexcept {
  if (std::all_of(data, data + layout.size, [](std::uint8_t byte) { return byte == 0; })) {
    return FrameStatus::kBlank;
  }
  if (layout.has_header && !(data[0] == 0xFE && data[1] == 0xEF)) return FrameStatus::kWrongHead;
  if (layout.has_header && data[2] != LOWLEVEL) return FrameStatus::kWrongLevel;
  std::uint32_t crc;
  std::memcpy(&crc, data + layout.size - 4, 4);
  return crc == crc32(data, layout.size - 4) ? FrameStatus::kOk : FrameStatus::kWrongCrc;
}

template <typename Struct>
FrameReport decode(LayoutFunction layout_of, const std::uint8_t* data, std::size_t size,
                   Generation generation, Struct decoded, Struct& out,
                   FrameExtras& extras) noexcept {
  FrameReport report;
  report.expected = report.detected = generation;
  report.size = size;
  const FrameLayout& layout = layout_of(generation);
  report.expected_size = layout.size;
  report.status = check_length(size, layout_of, report);
  if (report.status == FrameStatus::kOk) report.status = check_header_and_crc(layout, data);
  if (report.status != FrameStatus::kOk) return report;
  FrameExtras decoded_extras;
  unpack(layout, data, reinterpret_cast<std::uint8_t*>(&decoded), decoded_extras, report);
  if (report.status != FrameStatus::kOk) return report;
  std::memcpy(reinterpret_cast<std::uint8_t*>(&decoded) + offsetof(Struct, crc),
              data + layout.size - 4, 4);
  out = decoded;
  extras = decoded_extras;
  return report;
}

}  // namespace

std::size_t low_cmd_size(Generation generation) noexcept { return low_cmd_layout(generation).size; }
std::size_t low_state_size(Generation generation) noexcept {
  return low_state_layout(generation).size;
}

FrameReport encode_low_cmd(const LowCmd& cmd, const FrameExtras& extras, Generation generation,
                           Frame& out) noexcept {
  return encode(low_cmd_layout(generation), generation, cmd, extras, out);
}

FrameReport encode_low_state(const LowState& state, const FrameExtras& extras,
                             Generation generation, Frame& out) noexcept {
  return encode(low_state_layout(generation), generation, state, extras, out);
}

FrameReport decode_low_cmd(const std::uint8_t* data, std::size_t size, Generation generation,
                           LowCmd& cmd, FrameExtras& extras) noexcept {
  return decode(low_cmd_layout, data, size, generation, init_low_cmd(), cmd, extras);
}

FrameReport decode_low_state(const std::uint8_t* data, std::size_t size, Generation generation,
                             LowState& state, FrameExtras& extras) noexcept {
  return decode(low_state_layout, data, size, generation, init_low_state(), state, extras);
}

}  // namespace surefoot
