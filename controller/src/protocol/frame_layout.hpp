// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/frames.hpp"

namespace surefoot {

/// Conversion of a field between the struct (LowCmd, LowState) and the frame.
enum class FieldKind : std::uint8_t {
  kBytes,         ///< copied; `count` is a number of bytes
  kFloat,         ///< float, copied; the value must be finite
  kTorque,        ///< float [N.m] to int16, multiplied by FrameLayout::torque_unit
  kStiffness,     ///< float to uint16, in units of 1/32
  kDamping,       ///< float to uint16, in units of 1/16
  kInt16,         ///< float to int16, in units of 1
  kCellVoltage,   ///< uint16 [mV] to uint8, in units of 32 mV
  kUint16ToUint8  ///< uint16 to uint8
};

/// One field, or `count` equal fields in a row, in the order of the frame.
struct Field {
  const char* name;
  FieldKind kind;
  int count;
  std::size_t offset;  ///< [bytes] offset in its struct
  bool extra = false;  ///< true if its struct is FrameExtras, not LowCmd or LowState
};

/// Fields of one struct, or of an array of `repeat` structs.
struct Section {
  const Field* fields;
  int count;               ///< number of fields
  std::size_t offset = 0;  ///< [bytes] offset of the struct or array in LowCmd or LowState
  std::size_t stride = 0;  ///< [bytes] distance between two structs of the array
  int repeat = 1;
};

/// Layout of a frame. The sections describe everything but the CRC, the last four bytes.
struct FrameLayout {
  std::array<Section, 5> sections;
  int count;           ///< number of sections in use
  std::size_t size;    ///< [bytes] size of the frame, including the CRC
  bool has_header;     ///< true if the frame begins with FE EF and its levelFlag is checked
  double torque_unit;  ///< counts per N.m
};

/// Return the layout of a LowCmd frame. Real-time: yes.
const FrameLayout& low_cmd_layout(Generation generation) noexcept;
/// Return the layout of a LowState frame. Real-time: yes.
const FrameLayout& low_state_layout(Generation generation) noexcept;

}  // namespace surefoot
