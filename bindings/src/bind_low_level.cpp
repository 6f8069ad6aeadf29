// SPDX-License-Identifier: BSD-3-Clause
// LowState and LowCmd for Python.
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "packed_fields.hpp"
#include "surefoot/low_level.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

// A fixed row of structs that hands out references.
template <typename Element, std::size_t N>
void bind_struct_array(nb::module_& m, const char* name) {
  using Row = std::array<Element, N>;
  nb::class_<Row>(m, name, "Fixed row of motor slots; elements are references into the frame.")
      .def("__len__", [](const Row&) { return N; })
      .def(
          "__getitem__",
          [](Row& row, int i) -> Element& {
            if (i < 0) i += static_cast<int>(N);
            if (i < 0 || i >= static_cast<int>(N)) {
              throw nb::index_error("motor slot out of range: 0 .. 19");
            }
            return row[i];
          },
          nb::rv_policy::reference_internal);
}

template <typename Struct>
void def_bytes_access(nb::class_<Struct>& c, Struct (*make)() noexcept) {
  c.def("__init__", [make](Struct* self) { new (self) Struct(make()); });
  c.def("__copy__", [](const Struct& self) { return Struct(self); });
  c.def("__deepcopy__", [](const Struct& self, nb::dict) { return Struct(self); });
  c.def(
      "to_bytes",
      [](const Struct& s) { return nb::bytes(reinterpret_cast<const char*>(&s), sizeof(Struct)); },
      "Return the packed struct as the SDK's headers lay it out in memory (not the UDP frame).");
  c.def_static(
      "from_bytes",
      [](const nb::bytes& data) {
        if (data.size() != sizeof(Struct)) {
          const std::string text = "from_bytes: got " + std::to_string(data.size()) +
                                   " bytes, expected " + std::to_string(sizeof(Struct));
          throw nb::value_error(text.c_str());
        }
        Struct s;
        std::memcpy(&s, data.c_str(), sizeof(Struct));
        return s;
      },
      "data"_a, "Make the struct from the bytes that to_bytes() gave.");
  c.def_prop_ro(
      "raw",
      [](nb::handle self) {
        return View<std::uint8_t, sizeof(Struct)>(&nb::cast<Struct&>(self), {sizeof(Struct)}, self);
      },
      "The struct's bytes as a writable numpy view, shape (sizeof,).");
}

void bind_imu(nb::module_& m) {
  nb::class_<IMU> imu(m, "IMU", "Inertial measurement unit, in the IMU's own axes.");
  def_array(imu, "quaternion", &IMU::quaternion,
            "w, x, y, z: IMU to world, vendor's filter. Used.");
  def_array(imu, "gyroscope", &IMU::gyroscope, "Angular rate [rad/s], raw. Used.");
  def_array(imu, "accelerometer", &IMU::accelerometer,
            "Specific force [m/s^2], raw: +9.81 on z at rest. Used.");
  def_array(imu, "rpy", &IMU::rpy, "Roll, pitch, yaw [rad] (ZYX). Carried, not used.");
  def_number(imu, "temperature", &IMU::temperature, "[deg C]. Carried, not used.");
}

void bind_motor_state(nb::module_& m) {
  nb::class_<MotorState> c(m, "MotorState", "One motor's report, joint-side (gearing removed).");
  def_number(c, "mode", &MotorState::mode, "0x0A servo, 0x00 damping, 0x08 overheated.");
  def_number(c, "q", &MotorState::q, "Joint angle [rad]. Used.");
  def_number(c, "dq", &MotorState::dq, "Joint velocity [rad/s]. Used.");
  def_number(c, "ddq", &MotorState::ddq, "Joint acceleration [rad/s^2]. Carried, not used.");
  def_number(c, "tauEst", &MotorState::tauEst, "Torque from the motor current [N.m]. Used.");
  def_number(c, "q_raw", &MotorState::q_raw, "Vendor's reserve. Carried, not used.");
  def_number(c, "dq_raw", &MotorState::dq_raw, "Vendor's reserve. Carried, not used.");
  def_number(c, "ddq_raw", &MotorState::ddq_raw, "Vendor's reserve. Carried, not used.");
  def_number(c, "temperature", &MotorState::temperature, "[deg C]. Carried, not used.");
  def_array(c, "reserve", &MotorState::reserve, "Vendor's reserve. Carried, not used.");
  bind_struct_array<MotorState, kMotorSlots>(m, "MotorStateArray");
}

void bind_motor_cmd(nb::module_& m) {
  nb::class_<MotorCmd> c(
      m, "MotorCmd", "One motor's command: tau' = tau + Kp (q - q') + Kd (dq - dq'), joint-side.");
  def_number(c, "mode", &MotorCmd::mode, "0x0A servo, 0x00 damping.");
  def_number(c, "q", &MotorCmd::q, "Joint angle [rad], or PosStopF.");
  def_number(c, "dq", &MotorCmd::dq, "Joint velocity [rad/s], or VelStopF.");
  def_number(c, "tau", &MotorCmd::tau, "Feed-forward torque [N.m].");
  def_number(c, "Kp", &MotorCmd::Kp, "Position stiffness [N.m/rad].");
  def_number(c, "Kd", &MotorCmd::Kd, "Velocity stiffness [N.m.s/rad].");
  def_array(c, "reserve", &MotorCmd::reserve, "Vendor's reserve.");
  bind_struct_array<MotorCmd, kMotorSlots>(m, "MotorCmdArray");
}

void bind_battery(nb::module_& m) {
  nb::class_<BmsCmd> cmd(m, "BmsCmd", "Battery command. Surefoot never writes it.");
  def_number(cmd, "off", &BmsCmd::off, "0xA5 switches the battery off.");
  def_array(cmd, "reserve", &BmsCmd::reserve, "Vendor's reserve.");
  nb::class_<BmsState> c(m, "BmsState", "Battery report. Carried, not used.");
  def_number(c, "version_h", &BmsState::version_h, "Firmware version, high.");
  def_number(c, "version_l", &BmsState::version_l, "Firmware version, low.");
  def_number(c, "bms_status", &BmsState::bms_status, "Vendor's status code.");
  def_number(c, "SOC", &BmsState::SOC, "State of charge [%].");
  def_number(c, "current", &BmsState::current, "[mA].");
  def_number(c, "cycle", &BmsState::cycle, "Charge cycles.");
  def_array(c, "BQ_NTC", &BmsState::BQ_NTC, "[deg C].");
  def_array(c, "MCU_NTC", &BmsState::MCU_NTC, "[deg C].");
  def_array(c, "cell_vol", &BmsState::cell_vol, "[mV].");
}

template <typename Frame>
void def_header(nb::class_<Frame>& c) {
  def_array(c, "head", &Frame::head, "FE EF.");
  def_number(c, "levelFlag", &Frame::levelFlag, "LOWLEVEL (0xFF).");
  def_number(c, "frameReserve", &Frame::frameReserve, "Vendor's reserve.");
  def_array(c, "SN", &Frame::SN, "Serial number.");
  def_array(c, "version", &Frame::version, "Version.");
  def_number(c, "bandWidth", &Frame::bandWidth, "Band width.");
  def_array(c, "wirelessRemote", &Frame::wirelessRemote, "Remote control, 40 bytes.");
  def_number(c, "reserve", &Frame::reserve, "Vendor's reserve.");
  def_number(c, "crc", &Frame::crc, "CRC of the wire frame; carried, not computed here.");
}

void bind_states(nb::module_& m) {
  nb::class_<LowState> state(
      m, "LowState",
      "What the robot says every tick: unitree_legged_sdk v3.5 - v3.8 (Go1), 937 bytes, packed.\n\n"
      "Used: imu.quaternion, gyroscope, accelerometer; motorState q, dq, tauEst of motors 0 .. "
      "11;\n"
      "footForceEst; tick. Everything else is carried unused.");
  def_bytes_access(state, init_low_state);
  def_header(state);
  state.def_prop_ro(
      "imu", [](LowState& s) -> IMU& { return s.imu; }, nb::rv_policy::reference_internal, "IMU.");
  state.def_prop_ro(
      "motorState", [](LowState& s) -> auto& { return s.motorState; },
      nb::rv_policy::reference_internal, "20 slots, 12 motors: FR FL RR RL x hip thigh calf.");
  state.def_prop_ro(
      "bms", [](LowState& s) -> BmsState& { return s.bms; }, nb::rv_policy::reference_internal,
      "Battery report.");
  def_array(state, "footForce", &LowState::footForce, "Raw counts; own offset per foot, drifting.");
  def_array(state, "footForceEst", &LowState::footForceEst, "[N]; zero on most real robots. Used.");
  def_number(state, "tick", &LowState::tick, "[ms] modulo 2^32; only differences mean time. Used.");

  nb::class_<LowCmd> cmd(
      m, "LowCmd",
      "What the robot is told every tick: unitree_legged_sdk v3.5 - v3.8 (Go1), 734 bytes, "
      "packed.\n\n"
      "LowCmd() is what the SDK's InitCmdData makes: 20 slots, mode 0x0A, q = PosStopF,\n"
      "dq = VelStopF, tau = Kp = Kd = 0.");
  def_bytes_access(cmd, init_low_cmd);
  def_header(cmd);
  cmd.def_prop_ro(
      "motorCmd", [](LowCmd& c) -> auto& { return c.motorCmd; }, nb::rv_policy::reference_internal,
      "20 slots, 12 motors: FR FL RR RL x hip thigh calf.");
  cmd.def_prop_ro(
      "bms", [](LowCmd& c) -> BmsCmd& { return c.bms; }, nb::rv_policy::reference_internal,
      "Battery command.");
}

void bind_constants(nb::module_& m) {
  m.attr("PosStopF") = PosStopF;
  m.attr("VelStopF") = VelStopF;
  m.attr("LOWLEVEL") = static_cast<int>(LOWLEVEL);
  const char* legs[] = {"FR", "FL", "RR", "RL"};
  for (int i = 0; i < kMotors; ++i) {
    m.attr((std::string(legs[i / 3]) + "_" + std::to_string(i % 3)).c_str()) = i;
  }
}

}  // namespace

void bind_low_level(nb::module_& m) {
  bind_constants(m);
  bind_imu(m);
  bind_motor_state(m);
  bind_motor_cmd(m);
  bind_battery(m);
  bind_states(m);
  m.def("damping_low_cmd", &damping_low_cmd, "kd"_a,
        "Make the command in which every motor brakes by itself.\n\n"
        "mode 0x0A, q = PosStopF, dq = 0, tau = Kp = 0, Kd = kd [N.m.s/rad] on the 12 motors.");
}
