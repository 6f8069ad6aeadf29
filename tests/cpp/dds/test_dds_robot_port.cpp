// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "dds/link/topics.hpp"
#include "dds/network/endpoints.hpp"
#include "dds/wire/low_cmd_conversion.hpp"
#include "dds/wire/wire_crc.hpp"
#include "dds_environment.hpp"
#include "robot_end.hpp"
#include "surefoot/dds_link.hpp"
#include "surefoot/dds_robot_port.hpp"
#include "surefoot/error.hpp"
#include "wire_messages.hpp"

using namespace surefoot;

namespace {

struct PortFixture {
  std::shared_ptr<DdsNetwork> network = test_network();
  DdsRobotPort port{network, DdsRobot::kGo2, 0.1};
  DdsWriter commander{network->participant(), unitree_go_msg_dds__LowCmd__desc, kCommandTopic};
  LowCmd received;

  bool send(DdsLowCmd wire, bool with_crc = true) {
    if (with_crc) wire.crc = wire_crc(wire);
    commander.write(&wire);
    pause(10);
    return port.receive(received);
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(dds_robot_port, *boost::unit_test::precondition(has_libddsc))

BOOST_FIXTURE_TEST_CASE(valid_commands_are_read_and_others_are_counted, PortFixture) {
  BOOST_TEST(send(vendor_torque_command()));
  BOOST_TEST(received.motorCmd[0].tau == 0.5F);
  BOOST_TEST(!send(vendor_torque_command(), false));  // crc 0
  DdsLowCmd wrong = vendor_torque_command();
  wrong.motor_cmd[3].kp = std::numeric_limits<float>::quiet_NaN();
  BOOST_TEST(!send(wrong));
  std::memset(&wrong, 0, sizeof(wrong));
  BOOST_TEST(!send(wrong, false));
  BOOST_TEST(port.counts().commands == 1U);
  BOOST_TEST(port.counts().wrong_crc == 1U);
  BOOST_TEST(port.counts().not_finite == 1U);
  BOOST_TEST(port.counts().blank == 1U);
}

BOOST_FIXTURE_TEST_CASE(command_in_the_mode_of_another_robot_damps_and_is_counted, PortFixture) {
  BOOST_TEST(send(vendor_init_command(0x0A)));
  BOOST_TEST(received.motorCmd[0].mode == kModeDamping);
  BOOST_TEST(port.counts().not_servo == 1U);
}

BOOST_FIXTURE_TEST_CASE(second_robot_is_refused_by_name, PortFixture) {
  BOOST_CHECK_EXCEPTION(DdsRobotPort(network, DdsRobot::kGo2, 0.1), Error, [](const Error& error) {
    return std::string(error.what()).find("rt/lowstate: got 1 other writer(s) (process ") == 0;
  });
}

BOOST_AUTO_TEST_CASE(discovery_time_out_of_range_is_refused_by_name) {
  const auto network = test_network();
  for (const double time : {-0.1, 60.1, std::numeric_limits<double>::quiet_NaN()}) {
    BOOST_CHECK_EXCEPTION(
        DdsRobotPort(network, DdsRobot::kGo2, time), Error, [](const Error& error) {
          return std::string(error.what()).find("discovery_time: got ") == 0 &&
                 std::string(error.what()).find(", expected 0 .. 60 [s]") != std::string::npos;
        });
  }
}

BOOST_AUTO_TEST_CASE(sport_service_is_a_second_commander_until_it_ends) {
  const auto network = test_network();
  DdsRobotPort port(network, DdsRobot::kGo2, 0.1);
  port.set_sport_service(true);
  DdsLinkOptions options;
  options.discovery_time = 0.2;
  BOOST_CHECK_THROW(DdsLink(network, options), Error);
  port.set_sport_service(false);
  DdsLink link(network, options);
  BOOST_TEST(!link.status().conflict);
}

BOOST_AUTO_TEST_CASE(ten_thousand_random_states_pass_through_dds) {
  const auto network = test_network();
  RobotEnd robot(network->participant());
  DdsLinkOptions options;
  options.discovery_time = 0.1;
  DdsLink link(network, options);
  std::mt19937_64 random(1);
  for (int batch = 0; batch < 400; ++batch) {
    for (int k = 0; k < 25; ++k) {
      DdsLowState state;
      std::memset(&state, 0, sizeof(state));
      auto* bytes = reinterpret_cast<std::uint8_t*>(&state);
      for (auto changes = random() % 30; changes > 0; --changes)
        bytes[random() % sizeof(state)] = static_cast<std::uint8_t>(random());
      if (random() % 4 != 0) state.crc = wire_crc(state);
      robot.writer.write(&state);
    }
    link.receive();
  }
  pause(50);
  link.receive();
  const LinkCounts& counts = link.counts();
  BOOST_TEST(counts.received == 10000U);
  BOOST_TEST(counts.valid + counts.corrupt == counts.received);
  BOOST_TEST(counts.valid > 2000U);
  BOOST_TEST(counts.corrupt > 100U);
}

BOOST_AUTO_TEST_SUITE_END()
