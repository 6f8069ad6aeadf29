// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/frames.hpp"

namespace surefoot {

/// How a field changes between struct and wire.
enum class FieldKind : std::uint8_t {
  kBytes,         ///< as it is; the count is in bytes
  kFloat,         ///< float, as it is, if finite
  kTorque,        ///< float to int16, of the layout's unit
  kStiffness,     ///< float to uint16, of 1/32
  kDamping,       ///< float to uint16, of 1/16
  kInt16,         ///< float to int16
  kCellVoltage,   ///< uint16 to uint8, of 32
  kUint16ToUint8  ///< uint16 to uint8
};

/// One field, or `count` of them in a row, in the order of the wire.
struct Field {
  const char* name;
  FieldKind kind;
  int count;
  std::size_t offset;  ///< in its struct
  bool extra = false;  ///< its struct is FrameExtras
};

/// Fields of one struct, for an array of them `repeat` times.
struct Section {
  const Field* fields;
  int count;
  std::size_t offset = 0;  ///< of the first of the array, in LowCmd or LowState
  std::size_t stride = 0;
  int repeat = 1;
};

/// All of a frame but the CRC that ends it.
struct FrameLayout {
  std::array<Section, 5> sections;
  int count;
  std::size_t size;    ///< [bytes] with the CRC
  bool has_header;     ///< begins with FE EF and has its level checked
  double torque_unit;  ///< per N.m
};

const FrameLayout& low_cmd_layout(Generation generation) noexcept;
const FrameLayout& low_state_layout(Generation generation) noexcept;

}  // namespace surefoot
