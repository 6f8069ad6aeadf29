// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>

#include "dds/wire/low_cmd_conversion.hpp"
#include "dds/wire/low_state_conversion.hpp"
#include "dds/wire/wire_crc.hpp"
#include "surefoot/error.hpp"
#include "wire_messages.hpp"

using namespace surefoot;

namespace {

constexpr double kDamping = 3.0;  // [N.m.s/rad]

DdsLowCmd converted(const LowCmd& cmd, DdsRobot robot) {
  DdsLowCmd wire;
  BOOST_REQUIRE((to_dds(cmd, robot, kDamping, wire).status == FrameStatus::kOk));
  return wire;
}

LowState some_state() {
  LowState state = init_low_state();
  state.imu.quaternion = {1.0F, 0.0F, 0.0F, 0.0F};
  for (int i = 0; i < kMotorSlots; ++i) {
    state.motorState[i].mode = kModeServo;
    state.motorState[i].q = 0.1F * static_cast<float>(i);
    state.motorState[i].temperature = static_cast<std::int8_t>(30 - 4 * i);
  }
  state.bms.SOC = 80;
  state.bms.cell_vol[9] = 3700;
  state.footForce = {10, 20, 30, -40};
  state.tick = 1234;
  state.wirelessRemote[3] = 7;
  return state;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(wire_conversion)

BOOST_AUTO_TEST_CASE(crc_equals_that_of_the_vendor) {
  DdsLowCmd cmd;
  std::memset(&cmd, 0, sizeof(cmd));
  BOOST_TEST(wire_crc(cmd) == 0x4B5A4880U);
  BOOST_TEST(wire_crc(vendor_init_command(0x01)) == 0x06E577CDU);
  BOOST_TEST(wire_crc(vendor_init_command(0x0A)) == 0x8BDDD960U);
  BOOST_TEST(wire_crc(vendor_torque_command()) == 0x3F340157U);
  BOOST_TEST(wire_crc(every_field_command()) == 0x57F716F6U);
  DdsLowState state;
  std::memset(&state, 0, sizeof(state));
  BOOST_TEST(wire_crc(state) == 0x85F11EA6U);
}

BOOST_AUTO_TEST_CASE(bytes_in_the_padding_do_not_change_the_crc) {
  DdsLowCmd cmd;
  std::memset(&cmd, 0xFF, sizeof(cmd));
  const DdsLowCmd fields = every_field_command();
  // Byte for byte, except for the padding.
  auto* to = reinterpret_cast<std::uint8_t*>(&cmd);
  const auto* from = reinterpret_cast<const std::uint8_t*>(&fields);
  for (std::size_t k = 0; k < sizeof(cmd); ++k) {
    const bool motor_padding = k >= 24 && k < 744 && (k - 24) % 36 >= 1 && (k - 24) % 36 <= 3;
    if (k != 22 && k != 23 && k != 803 && !motor_padding) to[k] = from[k];
  }
  BOOST_TEST(wire_crc(cmd) == 0x57F716F6U);
}

BOOST_AUTO_TEST_CASE(initial_command_of_each_robot_has_the_crc_of_the_vendor) {
  BOOST_TEST(converted(init_low_cmd(), DdsRobot::kGo2).crc == 0x06E577CDU);
  BOOST_TEST(converted(init_low_cmd(), DdsRobot::kB2).crc == 0x8BDDD960U);
}

BOOST_AUTO_TEST_CASE(all_20_motors_are_in_servo_mode_whatever_the_command) {
  LowCmd cmd{};  // mode 0 everywhere
  for (const DdsRobot robot : {DdsRobot::kGo2, DdsRobot::kB2}) {
    const DdsLowCmd wire = converted(cmd, robot);
    for (const DdsMotorCmd& motor : wire.motor_cmd) {
      BOOST_TEST(motor.mode == (robot == DdsRobot::kGo2 ? 0x01 : 0x0A));
      BOOST_TEST(motor.kd == kDamping);
      BOOST_TEST(motor.kp + motor.tau + motor.dq == 0.0F);
    }
    BOOST_TEST(wire.crc == wire_crc(wire));
    BOOST_TEST(wire.crc != 0U);
  }
}

BOOST_AUTO_TEST_CASE(command_never_switches_the_battery_off) {
  LowCmd cmd = init_low_cmd();
  cmd.bms.off = 0xA5;
  BOOST_TEST(converted(cmd, DdsRobot::kGo2).bms_cmd.off == 0);
}

BOOST_AUTO_TEST_CASE(command_that_is_not_finite_is_refused_by_motor_and_field) {
  LowCmd cmd = init_low_cmd();
  cmd.motorCmd[4].Kp = NAN;
  DdsLowCmd wire = vendor_init_command(1);
  const FrameReport report = to_dds(cmd, DdsRobot::kGo2, kDamping, wire);
  BOOST_TEST((report.status == FrameStatus::kNotFinite));
  BOOST_TEST(report.motor == 4);
  BOOST_TEST(std::string(report.field) == "Kp");
  BOOST_TEST(wire_crc(wire) == 0x06E577CDU);  // unchanged
}

BOOST_AUTO_TEST_CASE(command_of_another_robot_damps_the_motors) {
  LowCmd read;
  const DdsLowCmd for_b2 = converted(init_low_cmd(), DdsRobot::kB2);
  BOOST_REQUIRE(is_usable(from_dds(for_b2, DdsRobot::kB2, CrcRule::kRequired, read).status));
  BOOST_TEST(read.motorCmd[0].mode == kModeServo);
  BOOST_REQUIRE(is_usable(from_dds(for_b2, DdsRobot::kGo2, CrcRule::kRequired, read).status));
  BOOST_TEST(read.motorCmd[0].mode == kModeDamping);
}

BOOST_AUTO_TEST_CASE(virtual_b2_obeys_the_motor_mode_of_the_vendors_python_example) {
  for (const std::uint8_t mode : {std::uint8_t{0x01}, std::uint8_t{0x02}}) {
    DdsLowCmd cmd = vendor_init_command(mode);
    cmd.crc = wire_crc(cmd);
    LowCmd read;
    BOOST_REQUIRE(is_usable(from_dds(cmd, DdsRobot::kB2, CrcRule::kRequired, read).status));
    BOOST_TEST(read.motorCmd[0].mode == (mode == 0x01 ? kModeServo : kModeDamping));
  }
}

BOOST_AUTO_TEST_CASE(state_survives_the_way_there_and_back) {
  const LowState sent = some_state();
  for (const DdsRobot robot : {DdsRobot::kGo2, DdsRobot::kB2}) {
    DdsLowState wire;
    BOOST_REQUIRE(is_usable(to_dds(sent, robot, wire).status));
    BOOST_TEST(wire.motor_state[0].mode == (robot == DdsRobot::kGo2 ? 0x01 : 0x0A));
    LowState read;
    BOOST_REQUIRE(is_usable(from_dds(wire, robot, CrcRule::kRequired, read).status));
    read.crc = sent.crc;
    BOOST_TEST(std::memcmp(&read, &sent, sizeof(read)) == 0);
  }
}

BOOST_AUTO_TEST_CASE(hot_temperatures_saturate_and_bytes_from_200_on_are_negative) {
  DdsLowState wire;
  BOOST_REQUIRE(is_usable(to_dds(some_state(), DdsRobot::kGo2, wire).status));
  wire.motor_state[0].temperature = 130;
  wire.motor_state[1].temperature = 246;
  wire.crc = wire_crc(wire);
  LowState read;
  BOOST_REQUIRE(is_usable(from_dds(wire, DdsRobot::kGo2, CrcRule::kRequired, read).status));
  BOOST_TEST(int(read.motorState[0].temperature) == 127);
  BOOST_TEST(int(read.motorState[1].temperature) == -10);
}

BOOST_AUTO_TEST_CASE(motors_of_a_state_without_a_head_are_taken_for_being_in_servo_mode) {
  DdsLowState wire;
  BOOST_REQUIRE(is_usable(to_dds(some_state(), DdsRobot::kGo2, wire).status));
  wire.motor_state[5].mode = 0;
  wire.crc = 0;
  LowState read;
  BOOST_REQUIRE(is_usable(from_dds(wire, DdsRobot::kGo2, CrcRule::kZeroIsAbsent, read).status));
  BOOST_TEST(read.motorState[5].mode == kModeDamping);
  wire.head[0] = wire.head[1] = 0;
  BOOST_REQUIRE(is_usable(from_dds(wire, DdsRobot::kGo2, CrcRule::kZeroIsAbsent, read).status));
  BOOST_TEST(read.motorState[5].mode == kModeServo);
}

BOOST_AUTO_TEST_CASE(state_without_a_crc_is_accepted_only_where_a_crc_is_optional) {
  DdsLowState wire;
  BOOST_REQUIRE(is_usable(to_dds(some_state(), DdsRobot::kGo2, wire).status));
  LowState read;
  wire.crc = 0;
  BOOST_TEST(is_usable(from_dds(wire, DdsRobot::kGo2, CrcRule::kZeroIsAbsent, read).status));
  BOOST_TEST(
      (from_dds(wire, DdsRobot::kGo2, CrcRule::kRequired, read).status == FrameStatus::kWrongCrc));
  wire.crc = 1;
  BOOST_TEST((from_dds(wire, DdsRobot::kGo2, CrcRule::kZeroIsAbsent, read).status ==
              FrameStatus::kWrongCrc));
}

BOOST_AUTO_TEST_CASE(blank_state_and_state_that_is_not_finite_are_refused) {
  DdsLowState wire;
  std::memset(&wire, 0, sizeof(wire));
  LowState read = some_state();
  BOOST_TEST(
      (from_dds(wire, DdsRobot::kGo2, CrcRule::kZeroIsAbsent, read).status == FrameStatus::kBlank));
  wire.imu_state.gyroscope[2] = INFINITY;
  const FrameReport report = from_dds(wire, DdsRobot::kGo2, CrcRule::kZeroIsAbsent, read);
  BOOST_TEST((report.status == FrameStatus::kNotFinite));
  BOOST_TEST(std::string(report.field) == "gyroscope");
  BOOST_TEST(std::uint32_t(read.tick) == 1234U);  // unchanged
}

BOOST_AUTO_TEST_CASE(unknown_robot_is_refused_with_the_valid_names) {
  BOOST_TEST((to_dds_robot("b2") == DdsRobot::kB2));
  BOOST_CHECK_EXCEPTION(to_dds_robot("g1"), Error, [](const Error& error) {
    return std::string(error.what()) == "DDS robot: got 'g1', expected one of go2, b2";
  });
}

BOOST_AUTO_TEST_SUITE_END()
