// SPDX-License-Identifier: BSD-3-Clause
// Bindings of LowState and LowCmd.
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "packed_fields.hpp"
#include "surefoot/low_level.hpp"

namespace nb = nanobind;
using namespace nb::literals;
using namespace surefoot;

namespace {

// Bind a fixed array of structs. Python gets references to its elements, not copies.
template <typename Element, std::size_t N>
void bind_struct_array(nb::module_& m, const char* name) {
  using Row = std::array<Element, N>;
  ValueClass<Row>(m, name,
                  "Fixed array of 20 motor slots. Writing to an element writes to the struct.")
      .def("__len__", [](const Row&) { return N; })
      .def(
          "__getitem__",
          [](Row& row, int i) -> Element& {
            if (i < 0) i += static_cast<int>(N);
            if (i < 0 || i >= static_cast<int>(N)) {
              throw nb::index_error("motor slot out of range, expected 0 .. 19");
            }
            return row[i];
          },
          nb::rv_policy::reference_internal);
}

template <typename Struct>
void def_bytes_access(ValueClass<Struct>& c, Struct (*make)() noexcept) {
  c.def(
      "__init__", [make](Struct* self) { new (self) Struct(make()); },
      "Create a message with head, levelFlag and default values.");
  c.def(
      "to_bytes",
      [](const Struct& s) { return nb::bytes(reinterpret_cast<const char*>(&s), sizeof(Struct)); },
      "Return the packed struct, laid out as in the SDK's headers (not the UDP frame).");
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
      "data"_a,
      "Make a struct from bytes that to_bytes() returned.\n\n"
      "Raises ValueError if the number of bytes is wrong.");
  c.def_prop_ro(
      "raw",
      [](nb::handle self) {
        return View<std::uint8_t, sizeof(Struct)>(&nb::cast<Struct&>(self), {sizeof(Struct)}, self);
      },
      "Bytes of the struct, a writable numpy view, shape (number of bytes,).");
}

void bind_imu(nb::module_& m) {
  ValueClass<IMU> imu(
      m, "IMU",
      "Inertial measurement unit, in the IMU's own axes. Arrays are writable numpy\n"
      "views.");
  imu.def(nb::init<>(), "Create a struct of zeros.");
  def_array(imu, "quaternion", &IMU::quaternion,
            "Quaternion w x y z from IMU to world axes, from the vendor's attitude filter.\n"
            "Read by StandController.");
  def_array(imu, "gyroscope", &IMU::gyroscope,
            "Angular velocity [rad/s], IMU axes, raw. Read by StandController.");
  def_array(imu, "accelerometer", &IMU::accelerometer,
            "Specific force [m/s^2], IMU axes, raw; +9.81 on z at rest. Read by\n"
            "StandController.");
  def_array(imu, "rpy", &IMU::rpy,
            "Roll, pitch, yaw [rad] (ZYX). Surefoot does not read this field.");
  def_number(imu, "temperature", &IMU::temperature,
             "Temperature [deg C]. Surefoot does not read this field.");
}

void bind_motor_state(nb::module_& m) {
  ValueClass<MotorState> c(
      m, "MotorState",
      "State of one motor, joint-side: the SDK has removed the gear ratio. Surefoot\n"
      "does not read a field whose description names no reader.");
  c.def(nb::init<>(), "Create a struct of zeros.");
  def_number(c, "mode", &MotorState::mode,
             "Motor mode, 0x0A servo, 0x00 damping, 0x08 overheated. Read by Supervisor.");
  def_number(c, "q", &MotorState::q, "Joint angle [rad]. Read by StandController.");
  def_number(c, "dq", &MotorState::dq, "Joint velocity [rad/s]. Read by StandController.");
  def_number(c, "ddq", &MotorState::ddq,
             "Joint acceleration [rad/s^2]. Surefoot does not read this field.");
  def_number(c, "tauEst", &MotorState::tauEst,
             "Joint torque estimated from the motor current [N.m]. Read by StandController.");
  def_number(c, "q_raw", &MotorState::q_raw,
             "Reserved by the vendor. Surefoot does not read this field.");
  def_number(c, "dq_raw", &MotorState::dq_raw,
             "Reserved by the vendor. Surefoot does not read this field.");
  def_number(c, "ddq_raw", &MotorState::ddq_raw,
             "Reserved by the vendor. Surefoot does not read this field.");
  def_number(c, "temperature", &MotorState::temperature,
             "Temperature [deg C]; lags behind that of the winding. Read by Supervisor.");
  def_array(c, "reserve", &MotorState::reserve, "Reserved by the vendor.");
  bind_struct_array<MotorState, kMotorSlots>(m, "MotorStateArray");
}

void bind_motor_cmd(nb::module_& m) {
  ValueClass<MotorCmd> c(m, "MotorCmd",
                         "Command to one motor, joint-side.\n\n"
                         "Torque of the motor, with its measured q_motor and dq_motor::\n\n"
                         "    tau_motor = tau + Kp (q - q_motor) + Kd (dq - dq_motor)");
  c.def(nb::init<>(), "Create a struct of zeros.");
  def_number(c, "mode", &MotorCmd::mode, "Motor mode, 0x0A servo or 0x00 damping.");
  def_number(c, "q", &MotorCmd::q, "Desired joint angle [rad], or PosStopF.");
  def_number(c, "dq", &MotorCmd::dq, "Desired joint velocity [rad/s], or VelStopF.");
  def_number(c, "tau", &MotorCmd::tau, "Feed-forward torque [N.m].");
  def_number(c, "Kp", &MotorCmd::Kp, "Position stiffness [N.m/rad].");
  def_number(c, "Kd", &MotorCmd::Kd, "Velocity damping [N.m.s/rad].");
  def_array(c, "reserve", &MotorCmd::reserve, "Reserved by the vendor.");
  bind_struct_array<MotorCmd, kMotorSlots>(m, "MotorCmdArray");
}

void bind_battery(nb::module_& m) {
  ValueClass<BmsCmd> cmd(m, "BmsCmd", "Battery command. Surefoot never writes this command.");
  cmd.def(nb::init<>(), "Create a struct of zeros.");
  def_number(cmd, "off", &BmsCmd::off, "0xA5 switches the battery off.");
  def_array(cmd, "reserve", &BmsCmd::reserve, "Reserved by the vendor.");
  ValueClass<BmsState> c(m, "BmsState",
                         "State of the battery. If SOC is low, the Supervisor lets the robot sit\n"
                         "down.");
  c.def(nb::init<>(), "Create a struct of zeros.");
  def_number(c, "version_h", &BmsState::version_h, "Firmware version, high byte.");
  def_number(c, "version_l", &BmsState::version_l, "Firmware version, low byte.");
  def_number(c, "bms_status", &BmsState::bms_status, "Status code of the vendor.");
  def_number(c, "SOC", &BmsState::SOC, "State of charge [%].");
  def_number(c, "current", &BmsState::current, "Battery current [mA].");
  def_number(c, "cycle", &BmsState::cycle, "Number of charge cycles.");
  def_array(c, "BQ_NTC", &BmsState::BQ_NTC,
            "Temperatures of the sensors BQ_NTC [deg C], shape (2,). The vendor does not say\n"
            "where these sensors are.");
  def_array(c, "MCU_NTC", &BmsState::MCU_NTC,
            "Temperatures of the sensors MCU_NTC [deg C], shape (2,). The vendor does not say\n"
            "where these sensors are.");
  def_array(c, "cell_vol", &BmsState::cell_vol, "Cell voltages [mV], shape (10,).");
}

template <typename Frame>
void def_header(ValueClass<Frame>& c) {
  def_array(c, "head", &Frame::head, "First bytes of a frame, 0xFE 0xEF.");
  def_number(c, "levelFlag", &Frame::levelFlag, "Level of the interface, LOWLEVEL (0xFF).");
  def_number(c, "frameReserve", &Frame::frameReserve, "Reserved by the vendor.");
  def_array(c, "SN", &Frame::SN, "Serial number, shape (2,).");
  def_array(c, "version", &Frame::version, "Version field of the vendor, shape (2,).");
  def_number(c, "bandWidth", &Frame::bandWidth, "Bandwidth field of the vendor.");
  def_array(c, "wirelessRemote", &Frame::wirelessRemote,
            "Bytes of the remote, shape (40,); see surefoot.protocol.WirelessRemote.");
  def_number(c, "reserve", &Frame::reserve, "Reserved by the vendor.");
  def_number(c, "crc", &Frame::crc,
             "CRC of the received frame. Encoding a frame ignores this field and computes the\n"
             "CRC.");
}

void bind_states(nb::module_& m) {
  ValueClass<LowState> state(
      m, "LowState",
      "Sample that the robot sends in every period.\n\n"
      "The struct is that of unitree_legged_sdk v3.5 - v3.8 (Go1), packed, 937 bytes.\n\n"
      "The StandController reads imu.quaternion, imu.gyroscope, imu.accelerometer; q,\n"
      "dq, tauEst of motors 0 .. 11; footForce; footForceEst; tick. The Supervisor also\n"
      "reads mode and temperature of the motors, bms and wirelessRemote. Surefoot only\n"
      "passes on all other fields.");
  def_bytes_access(state, init_low_state);
  def_header(state);
  state.def_prop_ro(
      "imu", [](LowState& s) -> IMU& { return s.imu; }, nb::rv_policy::reference_internal,
      "Inertial measurement unit; not a copy.");
  state.def_prop_ro(
      "motorState", [](LowState& s) -> auto& { return s.motorState; },
      nb::rv_policy::reference_internal,
      "States of 20 motor slots; 0 .. 11 are the motors in SDK order. Writing to an\n"
      "element writes to the struct.");
  state.def_prop_ro(
      "bms", [](LowState& s) -> BmsState& { return s.bms; }, nb::rv_policy::reference_internal,
      "State of the battery; not a copy.");
  def_array(state, "footForce", &LowState::footForce,
            "Foot forces [raw counts], shape (4,), FR FL RR RL. They grow with the load; the\n"
            "offsets differ and drift. Read by StandController.");
  def_array(state, "footForceEst", &LowState::footForceEst,
            "Foot forces [N], shape (4,), FR FL RR RL; zero on most real robots. Read by\n"
            "StandController.");
  def_number(state, "tick", &LowState::tick,
             "Time [ms] modulo 2^32; only differences have a meaning. Read by StandController.");

  ValueClass<LowCmd> cmd(
      m, "LowCmd",
      "Command to the robot, one in every period.\n\n"
      "The struct is that of unitree_legged_sdk v3.5 - v3.8 (Go1), packed, 734 bytes.\n"
      "LowCmd() makes the same command as InitCmdData of the SDK: 20 slots with mode\n"
      "0x0A, q = PosStopF, dq = VelStopF, tau = Kp = Kd = 0.");
  def_bytes_access(cmd, init_low_cmd);
  def_header(cmd);
  cmd.def_prop_ro(
      "motorCmd", [](LowCmd& c) -> auto& { return c.motorCmd; }, nb::rv_policy::reference_internal,
      "Commands of 20 motor slots; 0 .. 11 are the motors in SDK order. Writing to an\n"
      "element writes to the struct.");
  cmd.def_prop_ro(
      "bms", [](LowCmd& c) -> BmsCmd& { return c.bms; }, nb::rv_policy::reference_internal,
      "Battery command; not a copy.");
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
        "The 12 motors get mode 0x0A, q = PosStopF, dq = 0, tau = Kp = 0, Kd = kd. The\n"
        "motor drivers compute the damping, so it continues if the process that sent the\n"
        "command dies. Real-time: yes.\n\n"
        "Args:\n"
        "    kd: Kd of the motor drivers [N.m.s/rad], joint-side.");
}
