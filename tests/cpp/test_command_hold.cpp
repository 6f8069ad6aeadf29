// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "robot_states.hpp"
#include "safety/command_hold.hpp"

using namespace surefoot;

namespace {

LowCmd command_with_torque(float tau) {
  LowCmd command = init_low_cmd();
  command.motorCmd[0].tau = tau;
  return command;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(command_hold)

BOOST_AUTO_TEST_CASE(last_valid_command_is_held_for_10_ms) {
  CommandHold hold;
  hold.accept(command_with_torque(7.0F));
  for (int tick = 1; tick <= 5; ++tick) {
    const LowCmd& held = hold.repeat_or_damp(0.002, 3.0);
    BOOST_TEST(held.motorCmd[0].tau == 7.0F);
    BOOST_TEST(!hold.latched());
  }
  BOOST_TEST(motors_brake(hold.repeat_or_damp(0.002, 3.0)));
  BOOST_TEST(hold.latched());
}

BOOST_AUTO_TEST_CASE(valid_command_restarts_the_10_ms_hold) {
  CommandHold hold;
  hold.accept(command_with_torque(7.0F));
  for (int tick = 0; tick < 4; ++tick) hold.repeat_or_damp(0.002, 3.0);
  hold.accept(command_with_torque(8.0F));
  for (int tick = 0; tick < 5; ++tick) hold.repeat_or_damp(0.002, 3.0);
  BOOST_TEST(!hold.latched());
}

BOOST_AUTO_TEST_CASE(robot_never_controlled_is_damped_without_latching) {
  CommandHold hold;
  BOOST_TEST(motors_brake(hold.repeat_or_damp(0.002, 3.0)));
  BOOST_TEST(!hold.latched());
}

BOOST_AUTO_TEST_SUITE_END()
