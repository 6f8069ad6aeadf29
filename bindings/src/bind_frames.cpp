// SPDX-License-Identifier: BSD-3-Clause
// Bindings of the frames. Functions whose names begin with an underscore are internal;
// surefoot/protocol.py is their public interface.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "packed_fields.hpp"
#include "surefoot/error.hpp"
#include "surefoot/frames.hpp"
#include "surefoot/wireless_remote.hpp"

using namespace nb::literals;
using namespace surefoot;

namespace {

void require_usable(const char* what, const FrameReport& report) {
  if (!is_usable(report.status)) throw Error(std::string(what) + ": " + to_text(report));
}

// _encode_*() returns the bytes and a text about the saturated fields. The text is empty if no
// field is saturated.
template <typename Struct>
using Encode = FrameReport (*)(const Struct&, const FrameExtras&, Generation, Frame&) noexcept;
template <typename Struct>
using Decode = FrameReport (*)(const std::uint8_t*, std::size_t, Generation, Struct&,
                               FrameExtras&) noexcept;

template <typename Struct>
void def_frame(nb::module_& m, const char* what, Encode<Struct> encode, Decode<Struct> decode) {
  m.def((std::string("_encode_") + what).c_str(),
        [encode, what](const Struct& message, const FrameExtras& extras,
                       const std::string& generation) {
          Frame frame;
          const FrameReport report = encode(message, extras, to_generation(generation), frame);
          require_usable(what, report);
          const nb::bytes bytes(reinterpret_cast<const char*>(frame.bytes.data()), frame.size);
          return std::make_pair(
              bytes, report.status == FrameStatus::kOk ? std::string() : to_text(report));
        },
        "message"_a, "extras"_a, "generation"_a);
  m.def((std::string("_decode_") + what).c_str(),
        [decode, what](const nb::bytes& frame, const std::string& generation, Struct& decoded,
                       FrameExtras& extras) {
          const auto* data = reinterpret_cast<const std::uint8_t*>(frame.c_str());
          require_usable(what,
                         decode(data, frame.size(), to_generation(generation), decoded, extras));
        },
        "frame"_a, "generation"_a, "decoded"_a, "extras"_a);
}

void bind_extras(nb::module_& m) {
  ValueClass<FrameExtras> c(
      m, "FrameExtras",
      "Fields that some frame formats have but LowCmd and LowState do not.\n\n"
      "Surefoot only passes them on.");
  c.def(nb::init<>(), "Create fields of zeros.");
  def_number(c, "commVersion", &FrameExtras::commVersion,
             "Communication version. Only in generations a1-v3.3 and go1-v3.4.");
  def_number(c, "robotID", &FrameExtras::robotID,
             "Robot number. Only in generations a1-v3.3 and go1-v3.4.");
  c.def_field<Eigen::MatrixXd>(
      "led",
      [](nb::handle self) {
        auto* data = reinterpret_cast<std::uint8_t*>(nb::cast<FrameExtras&>(self).led.data());
        return nb::ndarray<nb::numpy, std::uint8_t, nb::shape<4, 3>>(data, {4, 3}, self);
      },
      [](FrameExtras& extras, FieldName field, nb::handle value) {
        const auto numbers = field_numbers<std::uint8_t, 12>(field, value, {4, 3});
        std::memcpy(extras.led.data(), numbers.data(), numbers.size());
      },
      "Red, green, blue of four lights, a writable view of shape (4, 3). Only in LowCmd\n"
      "of generation a1-v3.3.");
  def_array(c, "BQ_NTC", &FrameExtras::BQ_NTC,
            "Elements 2 .. 7 of BQ_NTC [deg C], shape (6,). BmsState.BQ_NTC has elements 0\n"
            "and 1. Only in LowState of generation b1-v3.8.");
  def_array(c, "MCU_NTC", &FrameExtras::MCU_NTC,
            "Elements 2 .. 7 of MCU_NTC [deg C], shape (6,). BmsState.MCU_NTC has elements 0\n"
            "and 1. Only in LowState of generation b1-v3.8.");
  def_array(c, "cell_vol", &FrameExtras::cell_vol,
            "Voltages of battery cells 10 .. 29 [mV], shape (20,). BmsState.cell_vol has\n"
            "cells 0 .. 9. Only in LowState of generation b1-v3.8.");
}

void bind_remote(nb::module_& m) {
  nb::enum_<Button>(m, "Button", "Buttons of the remote, by their bits in WirelessRemote.buttons.")
      .value("R1", Button::kR1, "Bit 0 of the buttons.")
      .value("L1", Button::kL1, "Bit 1 of the buttons.")
      .value("START", Button::kStart, "Bit 2 of the buttons.")
      .value("SELECT", Button::kSelect, "Bit 3 of the buttons.")
      .value("R2", Button::kR2, "Bit 4 of the buttons.")
      .value("L2", Button::kL2, "Bit 5 of the buttons.")
      .value("F1", Button::kF1, "Bit 6 of the buttons.")
      .value("F2", Button::kF2, "Bit 7 of the buttons.")
      .value("A", Button::kA, "Bit 8 of the buttons.")
      .value("B", Button::kB, "Bit 9 of the buttons.")
      .value("X", Button::kX, "Bit 10 of the buttons.")
      .value("Y", Button::kY, "Bit 11 of the buttons.")
      .value("UP", Button::kUp, "Bit 12 of the buttons.")
      .value("RIGHT", Button::kRight, "Bit 13 of the buttons.")
      .value("DOWN", Button::kDown, "Bit 14 of the buttons.")
      .value("LEFT", Button::kLeft, "Bit 15 of the buttons.");
  ValueClass<WirelessRemote>(m, "WirelessRemote",
                             "Buttons and sticks in the 40 bytes of LowState.wirelessRemote.\n\n"
                             "The layout is that of the SDK's joystick.h.")
      .def(nb::init<>(), "Create a remote at rest.")
      .def_rw("buttons", &WirelessRemote::buttons, "One bit per button, see Button.")
      .def_rw("lx", &WirelessRemote::lx, "Left stick, -1 .. 1, positive to the right.")
      .def_rw("ly", &WirelessRemote::ly, "Left stick, -1 .. 1, positive up.")
      .def_rw("rx", &WirelessRemote::rx, "Right stick, -1 .. 1, positive to the right.")
      .def_rw("ry", &WirelessRemote::ry, "Right stick, -1 .. 1, positive up.")
      .def_rw("L2", &WirelessRemote::L2, "Trigger L2, 0 .. 1.")
      .def("pressed", &WirelessRemote::pressed, "button"_a, "Return whether a button is pressed.")
      .def(
          "press",
          [](WirelessRemote& r, Button button) { r.buttons |= static_cast<std::uint16_t>(button); },
          "button"_a, "Mark a button as pressed.")
      .def(
          "to_bytes",
          [](const WirelessRemote& r) {
            const auto bytes = encode_wireless_remote(r);
            return nb::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
          },
          "Encode as the 40 bytes of LowState.wirelessRemote.")
      .def_static(
          "from_bytes",
          [](const nb::bytes& data) {
            std::array<std::uint8_t, 40> bytes;
            if (data.size() != bytes.size()) {
              throw nb::value_error(
                  ("from_bytes: got " + std::to_string(data.size()) + " bytes, expected 40")
                      .c_str());
            }
            std::memcpy(bytes.data(), data.c_str(), bytes.size());
            return decode_wireless_remote(bytes);
          },
          "data"_a,
          "Decode the 40 bytes of LowState.wirelessRemote.\n\n"
          "All bytes are zero if the remote is at rest or missing. If a stick value is not\n"
          "finite or its magnitude is above 1.05, all sticks are set to 0; the buttons are\n"
          "still decoded. Raises ValueError if the number of bytes is not 40.");
}

}  // namespace

void bind_frames(nb::module_& m) {
  bind_extras(m);
  bind_remote(m);
  def_frame<LowCmd>(m, "low_cmd", encode_low_cmd, decode_low_cmd);
  def_frame<LowState>(m, "low_state", encode_low_state, decode_low_state);
  m.def("_generations", [] {
    std::vector<std::string> names;
    for (int g = 0; g < kGenerations; ++g)
      names.emplace_back(to_string(static_cast<Generation>(g)));
    return names;
  });
  m.def(
      "_frame_sizes",
      [](const std::string& generation) {
        const Generation g = to_generation(generation);
        return std::make_pair(low_cmd_size(g), low_state_size(g));
      },
      "generation"_a);
  m.def(
      "_crc32",
      [](const nb::bytes& data) {
        return crc32(reinterpret_cast<const std::uint8_t*>(data.c_str()), data.size());
      },
      "data"_a);
}
