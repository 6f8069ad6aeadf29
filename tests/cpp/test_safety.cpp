// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "low_state_check.hpp"
#include "quadruped.hpp"
#include "safety/command_keeper.hpp"
#include "safety/tick_clock.hpp"

using namespace surefoot;

namespace {

LowCmd marked(float tau) {
  LowCmd command = init_low_cmd();
  command.motorCmd[0].tau = tau;
  return command;
}

bool damps(const LowCmd& command) {
  const MotorCmd& motor = command.motorCmd[5];
  return motor.mode == kModeServo && motor.Kd > 0.0F && motor.dq == 0.0F && motor.tau == 0.0F &&
         motor.Kp == 0.0F && motor.q == static_cast<float>(PosStopF);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(safety)

BOOST_AUTO_TEST_CASE(the_last_good_command_is_held_ten_milliseconds_and_no_longer) {
  CommandKeeper keeper;
  keeper.accept(marked(7.0F));
  for (int tick = 1; tick <= 5; ++tick) {
    const LowCmd& held = keeper.refuse(0.002, 3.0);
    BOOST_TEST(held.motorCmd[0].tau == 7.0F);
    BOOST_TEST(!keeper.latched());
  }
  BOOST_TEST(damps(keeper.refuse(0.002, 3.0)));
  BOOST_TEST(keeper.latched());
}

BOOST_AUTO_TEST_CASE(a_good_tick_in_between_starts_the_count_anew) {
  CommandKeeper keeper;
  keeper.accept(marked(7.0F));
  for (int tick = 0; tick < 4; ++tick) keeper.refuse(0.002, 3.0);
  keeper.accept(marked(8.0F));
  for (int tick = 0; tick < 5; ++tick) keeper.refuse(0.002, 3.0);
  BOOST_TEST(!keeper.latched());
}

BOOST_AUTO_TEST_CASE(a_robot_never_under_control_is_damped_without_latching) {
  CommandKeeper keeper;
  BOOST_TEST(damps(keeper.refuse(0.002, 3.0)));
  BOOST_TEST(!keeper.latched());
}

BOOST_AUTO_TEST_CASE(time_comes_from_tick_differences_across_the_wrap) {
  TickClock clock;
  BOOST_TEST(clock.advance(0xFFFFFFFFU) == 0.0);
  BOOST_TEST(clock.advance(0x00000001U) == 0.002);
  BOOST_TEST(clock.period() == 0.002);
}

BOOST_AUTO_TEST_CASE(a_tick_that_stands_still_or_runs_back_is_told_and_forgotten) {
  TickClock clock;
  clock.advance(100);
  clock.advance(104);
  BOOST_TEST(clock.advance(104) < 0.0);
  BOOST_TEST(clock.advance(90) < 0.0);
  BOOST_TEST(clock.advance(106) == 0.002);
}

BOOST_AUTO_TEST_CASE(a_long_gap_is_integrated_as_ten_milliseconds) {
  TickClock clock;
  clock.advance(0);
  BOOST_TEST(clock.advance(500) == 0.5);
  BOOST_TEST(clock.period() == TickClock::kMaxStep);
}

BOOST_AUTO_TEST_CASE(absurd_numbers_count_as_not_finite) {
  const LowState good = resting_report(quadruped(), 0);
  BOOST_TEST(finite(good));
  for (const float bad : {std::nanf(""), INFINITY, -INFINITY, 1e30F}) {
    for (int field = 0; field < 6; ++field) {
      LowState report = good;
      if (field == 0) report.imu.quaternion[2] = bad;
      if (field == 1) report.imu.gyroscope[1] = bad;
      if (field == 2) report.imu.accelerometer[0] = bad;
      if (field == 3) report.motorState[11].q = bad;
      if (field == 4) report.motorState[0].dq = bad;
      if (field == 5) report.motorState[6].tauEst = bad;
      BOOST_TEST(!finite(report));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
