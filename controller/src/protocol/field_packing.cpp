// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/field_packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace surefoot {

namespace {

// Counts per unit in the vendor's frames. tests/cpp/test_frames.cpp compares frames with those of
// the vendor.
constexpr double kStiffnessUnit = 32.0, kDampingUnit = 16.0, kWholeUnit = 1.0;
constexpr int kCellVoltageUnit = 32;  // [mV] one count

template <typename T>
T load(const std::uint8_t* from) noexcept {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}
template <typename T>
void store(std::uint8_t* to, T value) noexcept {
  std::memcpy(to, &value, sizeof(T));
}

// Keep the first problem, but let a value that is not finite replace a value out of range.
void record_problem(FrameReport& report, FrameStatus status, const Field& field,
                    int motor) noexcept {
  if (report.status == FrameStatus::kNotFinite || report.status == status) return;
  report.status = status;
  report.field = field.name;
  report.motor = motor;
}

// Convert to fixed point. The value is truncated towards zero as in the vendor's code, but
// saturates where the vendor's code wraps around.
template <typename T>
T to_fixed_point(double value, double unit, FrameStatus& status) noexcept {
  if (!std::isfinite(value)) {
    status = FrameStatus::kNotFinite;
    return 0;
  }
  const double whole = std::trunc(value * unit);
  constexpr double kMin = std::numeric_limits<T>::min(), kMax = std::numeric_limits<T>::max();
  if (whole < kMin || whole > kMax) status = FrameStatus::kSaturated;
  return static_cast<T>(std::clamp(whole, kMin, kMax));
}

std::uint8_t to_uint8(int value, FrameStatus& status) noexcept {
  if (value > 255) status = FrameStatus::kSaturated;
  return static_cast<std::uint8_t>(std::min(value, 255));
}

// Convert one element from the struct to the frame, and advance both pointers.
FrameStatus pack_one(FieldKind kind, double torque_unit, const std::uint8_t*& from,
                     std::uint8_t*& to) noexcept {
  FrameStatus status = FrameStatus::kOk;
  const auto as_int16 = [&](double unit) {
    store(to, to_fixed_point<std::int16_t>(load<float>(from), unit, status));
  };
  const auto as_uint16 = [&](double unit) {
    store(to, to_fixed_point<std::uint16_t>(load<float>(from), unit, status));
  };
  switch (kind) {
    case FieldKind::kBytes:
      *to++ = *from++;
      return status;
    case FieldKind::kFloat:
      if (!std::isfinite(load<float>(from))) status = FrameStatus::kNotFinite;
      std::memcpy(to, from, 4);
      from += 4, to += 4;
      return status;
    case FieldKind::kCellVoltage:
      *to++ = to_uint8(load<std::uint16_t>(from) / kCellVoltageUnit, status);
      from += 2;
      return status;
    case FieldKind::kUint16ToUint8:
      *to++ = to_uint8(load<std::uint16_t>(from), status);
      from += 2;
      return status;
    case FieldKind::kTorque:
      as_int16(torque_unit);
      break;
    case FieldKind::kInt16:
      as_int16(kWholeUnit);
      break;
    case FieldKind::kStiffness:
      as_uint16(kStiffnessUnit);
      break;
    case FieldKind::kDamping:
      as_uint16(kDampingUnit);
      break;
  }
  from += 4, to += 2;
  return status;
}

// Convert one element from the frame to the struct, and advance both pointers.
FrameStatus unpack_one(FieldKind kind, double torque_unit, const std::uint8_t*& from,
                       std::uint8_t*& to) noexcept {
  FrameStatus status = FrameStatus::kOk;
  switch (kind) {
    case FieldKind::kBytes:
      *to++ = *from++;
      return status;
    case FieldKind::kFloat:
      if (!std::isfinite(load<float>(from))) status = FrameStatus::kNotFinite;
      std::memcpy(to, from, 4);
      from += 4, to += 4;
      return status;
    case FieldKind::kCellVoltage:
      store(to, static_cast<std::uint16_t>(kCellVoltageUnit * *from++));
      to += 2;
      return status;
    case FieldKind::kUint16ToUint8:
      store(to, static_cast<std::uint16_t>(*from++));
      to += 2;
      return status;
    case FieldKind::kTorque:
      store(to, static_cast<float>(load<std::int16_t>(from) / torque_unit));
      break;
    case FieldKind::kInt16:
      store(to, static_cast<float>(load<std::int16_t>(from) / kWholeUnit));
      break;
    case FieldKind::kStiffness:
      store(to, static_cast<float>(load<std::uint16_t>(from) / kStiffnessUnit));
      break;
    case FieldKind::kDamping:
      store(to, static_cast<float>(load<std::uint16_t>(from) / kDampingUnit));
      break;
  }
  from += 2, to += 4;
  return status;
}

// Call move(field, offset in its struct, motor or -1) for every field, in the order of the frame.
template <typename Move>
void for_each_field(const FrameLayout& layout, Move&& move) noexcept {
  for (int s = 0; s < layout.count; ++s) {
    const Section& section = layout.sections[s];
    for (int k = 0; k < section.repeat; ++k) {
      for (int f = 0; f < section.count; ++f) {
        const Field& field = section.fields[f];
        move(field, section.offset + k * section.stride + field.offset,
             section.repeat > 1 ? k : -1);
      }
    }
  }
}

}  // namespace

void pack(const FrameLayout& layout, const std::uint8_t* base, const FrameExtras& extras,
          std::uint8_t* wire, FrameReport& report) noexcept {
  const auto* extras_bytes = reinterpret_cast<const std::uint8_t*>(&extras);
  for_each_field(layout, [&](const Field& field, std::size_t offset, int motor) {
    const std::uint8_t* from = (field.extra ? extras_bytes : base) + offset;
    for (int k = 0; k < field.count; ++k) {
      const FrameStatus status = pack_one(field.kind, layout.torque_unit, from, wire);
      if (status != FrameStatus::kOk) record_problem(report, status, field, motor);
    }
  });
}

void unpack(const FrameLayout& layout, const std::uint8_t* wire, std::uint8_t* base,
            FrameExtras& extras, FrameReport& report) noexcept {
  auto* extras_bytes = reinterpret_cast<std::uint8_t*>(&extras);
  for_each_field(layout, [&](const Field& field, std::size_t offset, int motor) {
    std::uint8_t* to = (field.extra ? extras_bytes : base) + offset;
    for (int k = 0; k < field.count; ++k) {
      const FrameStatus status = unpack_one(field.kind, layout.torque_unit, wire, to);
      if (status != FrameStatus::kOk) record_problem(report, status, field, motor);
    }
  });
}

}  // namespace surefoot
