// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/frame_layout.hpp"
#include "surefoot/error.hpp"

namespace surefoot {

const char* to_string(Generation generation) noexcept {
  constexpr const char* kNames[kGenerations] = {"a1-v3.3", "go1-v3.4", "go1-v3.8", "b1-v3.8"};
  return kNames[static_cast<int>(generation)];
}

Generation to_generation(const std::string& name) {
  std::string valid;
  for (int g = 0; g < kGenerations; ++g) {
    const auto generation = static_cast<Generation>(g);
    if (name == to_string(generation)) return generation;
    valid += std::string(g ? ", " : "") + to_string(generation);
  }
  throw Error("SDK generation: got '" + name + "', expected one of " + valid);
}

const char* to_string(FrameStatus status) noexcept {
  switch (status) {
    case FrameStatus::kOk:
      return "ok";
    case FrameStatus::kSaturated:
      return "saturated";
    case FrameStatus::kNotFinite:
      return "not finite";
    case FrameStatus::kWrongLength:
      return "wrong length";
    case FrameStatus::kWrongGeneration:
      return "wrong generation";
    case FrameStatus::kBlank:
      return "blank";
    case FrameStatus::kWrongHead:
      return "wrong head";
    case FrameStatus::kWrongLevel:
      return "wrong level";
    case FrameStatus::kWrongCrc:
      return "wrong crc";
  }
  return "unknown";
}

std::string to_text(const FrameReport& report) {
  const std::string field =
      (report.motor < 0 ? "" : "motor " + std::to_string(report.motor) + ", ") + report.field;
  const std::string got = "got " + std::to_string(report.size) + " bytes";
  const std::string expected = to_string(report.expected);
  const std::string expected_frame =
      ", expected " + std::to_string(report.expected_size) + " bytes, a frame of " + expected;
  switch (report.status) {
    case FrameStatus::kOk:
      return "ok";
    case FrameStatus::kSaturated:
      return field + ": out of range of a " + expected + " frame, set to its limit";
    case FrameStatus::kNotFinite:
      return field + ": got NaN or infinity, expected a finite number";
    case FrameStatus::kWrongLength:
      return got + ", the length of no generation's frame" + expected_frame;
    case FrameStatus::kWrongGeneration:
      return got + ", a frame of " + to_string(report.detected) + expected_frame;
    case FrameStatus::kBlank:
      return got + ", all zero, as the vendor's SDK sends before its first command";
    case FrameStatus::kWrongHead:
      return got + ", expected a " + expected + " frame, which begins with FE EF";
    case FrameStatus::kWrongLevel:
      return got +
             " with a wrong levelFlag, expected LOWLEVEL (0xFF): the robot is in high-level mode";
    case FrameStatus::kWrongCrc:
      return got + " with a wrong CRC";
  }
  return "unknown";
}

}  // namespace surefoot
