// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "safety/tick_clock.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(tick_clock)

BOOST_AUTO_TEST_CASE(time_step_is_correct_across_the_tick_wrap) {
  TickClock clock;
  BOOST_TEST(clock.advance(0xFFFFFFFFU) == 0.0);
  BOOST_TEST(clock.advance(0x00000001U) == 0.002);
  BOOST_TEST(clock.period() == 0.002);
}

BOOST_AUTO_TEST_CASE(repeated_or_backward_tick_is_rejected_and_ignored) {
  TickClock clock;
  clock.advance(100);
  clock.advance(104);
  BOOST_TEST(clock.advance(104) < 0.0);
  BOOST_TEST(clock.advance(90) < 0.0);
  BOOST_TEST(clock.advance(106) == 0.002);
}

BOOST_AUTO_TEST_CASE(gap_of_50_ms_is_returned_in_full) {
  TickClock clock;
  clock.advance(0);
  BOOST_TEST(clock.advance(50) == 0.05);
  BOOST_TEST(clock.gap() == 0.05);
}

BOOST_AUTO_TEST_CASE(shorter_maximum_gap_requires_confirmation_of_a_tick_jump) {
  TickClock clock(0.015);
  clock.advance(0);
  BOOST_TEST(clock.advance(14) == 0.014);
  BOOST_TEST(clock.advance(64) < 0.0);
  BOOST_TEST(clock.advance(66) == TickClock::kMaxStep);
  BOOST_TEST(std::abs(clock.gap() - 0.052) < 1e-12);
  TickClock slow(0.015);  // at 100 Hz, two or three samples may be lost
  for (const std::uint32_t tick : {0U, 10U, 20U, 30U, 40U}) slow.advance(tick);
  BOOST_TEST(slow.advance(80) == 0.04);
}

BOOST_AUTO_TEST_CASE(tick_jump_is_accepted_only_after_the_next_tick_confirms_it) {
  TickClock clock;
  clock.advance(100);
  BOOST_TEST(clock.advance(1000000000) < 0.0);
  BOOST_TEST(clock.advance(102) == 0.002);  // the jump was a wrong value: no time was lost
  BOOST_TEST(clock.advance(600000) < 0.0);
  BOOST_TEST(clock.advance(600002) == TickClock::kMaxStep);
  BOOST_TEST(clock.advance(600004) == 0.002);
}

BOOST_AUTO_TEST_CASE(lost_sample_does_not_change_the_clock_period) {
  TickClock clock;
  for (const std::uint32_t tick : {0U, 2U, 4U, 8U}) clock.advance(tick);
  BOOST_TEST(clock.period() == 0.002);
  for (const std::uint32_t tick : {12U, 16U}) clock.advance(tick);
  BOOST_TEST(clock.period() == 0.004);
}

BOOST_AUTO_TEST_CASE(jittering_samples_give_the_longer_period) {
  TickClock clock;
  for (const std::uint32_t tick : {0U, 3U, 4U, 7U, 8U}) clock.advance(tick);
  BOOST_TEST(clock.period() == 0.003);
}

BOOST_AUTO_TEST_SUITE_END()
