// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "gait/gait_clock.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;
constexpr double kPeriod = 0.4;

struct ClockFixture {
  GaitClock clock;
  GaitTiming timing;
  bool stop = false;
  double max_wait = 0.0;

  ClockFixture() { set_duty(0.6); }
  void set_duty(double duty) {
    timing.period = kPeriod;
    timing.duty = duty;
    clock.start();
  }
  void tick() { clock.advance(timing, max_wait, stop, kDt); }
  void run(double seconds) {
    for (int k = 0; k < seconds / kDt - 0.5; ++k) tick();
  }
  int swing_feet() const {
    int count = 0;
    for (int leg = 0; leg < kLegs; ++leg) count += clock.in_swing(leg);
    return count;
  }
  double time_until_swing(int leg) {
    double time = 0.0;
    for (; !clock.in_swing(leg) && time < 10.0; time += kDt) tick();
    return time;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_clock)

BOOST_FIXTURE_TEST_CASE(all_legs_stand_at_the_start_and_unload_before_their_first_swing,
                        ClockFixture) {
  for (const double duty : {0.4, 0.5, 0.6}) {
    set_duty(duty);
    tick();
    BOOST_TEST(swing_feet() == 0);
    double least = kPeriod;
    while (swing_feet() == 0) {
      for (int leg = 0; leg < kLegs; ++leg) least = std::min(least, clock.time_to_liftoff(leg));
      tick();
    }
    BOOST_TEST(least < 2.0 * kDt);  // the lift-off was announced
  }
}

BOOST_FIXTURE_TEST_CASE(pair_of_a_given_leg_can_swing_at_once, ClockFixture) {
  set_duty(0.5);
  for (const int leg : {FR_, FL_, RR_, RL_}) {
    clock.start_swing(timing, leg);
    tick();
    BOOST_TEST(swing_feet() == 2);
    BOOST_TEST(clock.in_swing(leg));
    BOOST_TEST(clock.swing_progress(leg) < 0.02);
  }
}

BOOST_FIXTURE_TEST_CASE(diagonal_pairs_swing_in_turn_at_every_duty, ClockFixture) {
  for (const double duty : {0.4, 0.5, 0.6}) {
    set_duty(duty);
    run(kPeriod);                // a leg may skip its first swing
    std::array<int, 5> ticks{};  // by number of swing feet
    int swing_ticks = 0;
    for (int k = 0; k < 10 * kPeriod / kDt - 0.5; ++k) {
      tick();
      ++ticks[swing_feet()];
      swing_ticks += clock.in_swing(FR_);
      BOOST_REQUIRE(clock.in_swing(FR_) == clock.in_swing(RL_));
      BOOST_REQUIRE(clock.in_swing(FL_) == clock.in_swing(RR_));
    }
    const double all = 10 * kPeriod / kDt;
    BOOST_TEST(std::abs(swing_ticks / all - (1.0 - duty)) < 0.01);
    // Both pairs share the ground above a duty of 0.5, and both are in the air below it.
    BOOST_TEST(std::abs(ticks[0] / all - std::max(2.0 * duty - 1.0, 0.0)) < 0.01);
    BOOST_TEST(std::abs(ticks[4] / all - std::max(1.0 - 2.0 * duty, 0.0)) < 0.01);
  }
}

BOOST_FIXTURE_TEST_CASE(all_feet_stand_at_the_start, ClockFixture) {
  set_duty(0.52);
  tick();
  BOOST_TEST(swing_feet() == 0);
  BOOST_TEST(std::abs(clock.time_to_liftoff(FL_) - 0.02 * kPeriod + kDt) < 1e-9);
  BOOST_TEST(clock.time_to_touchdown(FL_) == 0.0);
  BOOST_TEST(clock.swing_progress(FL_) == 0.0);
}

BOOST_FIXTURE_TEST_CASE(progress_and_times_of_a_swing_agree, ClockFixture) {
  time_until_swing(FL_);
  double last = -1.0;
  for (; clock.in_swing(FL_); tick()) {
    const double progress = clock.swing_progress(FL_);
    BOOST_REQUIRE(progress > last);
    BOOST_REQUIRE(std::abs(clock.time_to_touchdown(FL_) - (1.0 - progress) * timing.swing_time()) <
                  1e-9);
    BOOST_REQUIRE(clock.time_to_liftoff(FL_) == 0.0);
    last = progress;
  }
  BOOST_TEST(last > 0.95);
  BOOST_TEST(std::abs(clock.time_to_liftoff(FL_) - timing.stance_time()) < 2.0 * kDt);
}

BOOST_FIXTURE_TEST_CASE(clock_waits_for_late_feet_for_the_given_time, ClockFixture) {
  max_wait = 0.06;
  const double lasts = max_wait + GaitClock::kUnloadingTime;
  BOOST_TEST(std::abs(time_until_swing(FL_) - (0.1 * kPeriod + lasts)) < 3.0 * kDt);
  // The next lift-off, half a period later, may wait as long again.
  BOOST_TEST(std::abs(time_until_swing(FR_) - (0.5 * kPeriod + lasts)) < 3.0 * kDt);
}

BOOST_FIXTURE_TEST_CASE(waiting_feet_unload_as_soon_as_late_feet_land, ClockFixture) {
  max_wait = 0.06;
  run(0.1 * kPeriod + 0.02);
  BOOST_TEST(clock.time_to_liftoff(FL_) == kPeriod);
  max_wait = 0.0;
  for (double left = GaitClock::kUnloadingTime - kDt; left > 0.5 * kDt; left -= kDt) {
    tick();
    BOOST_TEST(swing_feet() == 0);
    BOOST_TEST(std::abs(clock.time_to_liftoff(FL_) - left) < 1e-9);
  }
  BOOST_TEST(time_until_swing(FL_) <= 2.0 * kDt);
}

// Feet that wait carry their load: their lift-off is a period away.
BOOST_FIXTURE_TEST_CASE(waiting_feet_stand_while_the_other_pair_is_down, ClockFixture) {
  set_duty(0.5);
  time_until_swing(FL_);
  while (clock.time_to_touchdown(FL_) > 2.0 * kDt) tick();
  max_wait = 1.0;
  run(0.1);
  BOOST_TEST(swing_feet() == 0);
  BOOST_TEST(clock.time_to_liftoff(FR_) == kPeriod);
  max_wait = 0.0;
  time_until_swing(FR_);
  BOOST_TEST((clock.in_swing(FR_) && clock.in_swing(RL_) && !clock.in_swing(FL_)));
  BOOST_TEST(clock.swing_progress(FR_) < 0.03);
}

BOOST_FIXTURE_TEST_CASE(clock_does_not_wait_while_no_foot_is_about_to_lift_off, ClockFixture) {
  time_until_swing(FL_);
  max_wait = 0.06;
  const double progress = clock.swing_progress(FL_);
  tick();
  BOOST_TEST(std::abs(clock.swing_progress(FL_) - progress - kDt / timing.swing_time()) < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(stop_keeps_standing_feet_down_and_lets_swing_feet_land, ClockFixture) {
  time_until_swing(FL_);
  stop = true;
  run(0.5 * timing.swing_time());
  BOOST_TEST((clock.in_swing(FL_) && clock.in_swing(RR_)));
  run(0.5 * timing.swing_time() + 2.0 * kDt);
  for (int k = 0; k < 3 * kPeriod / kDt; ++k) {
    tick();
    BOOST_REQUIRE(swing_feet() == 0);
    BOOST_REQUIRE(clock.time_to_touchdown(FR_) == 0.0);
  }
  BOOST_TEST(clock.time_to_liftoff(FR_) == kPeriod);
}

BOOST_FIXTURE_TEST_CASE(foot_of_a_walk_lands_in_the_timing_of_a_trot, ClockFixture) {
  timing.duty = 0.8;
  timing.offset = {0.05, 0.3, 0.55, 0.8};
  time_until_swing(RR_);
  run(0.6 * timing.swing_time());
  const double progress = clock.swing_progress(RR_);
  timing = GaitTiming();
  clock.continue_swing(timing, RR_);
  BOOST_TEST(std::abs(clock.swing_progress(RR_) - progress) < 1e-9);
  BOOST_TEST((clock.in_swing(RR_) && swing_feet() == 1));
  time_until_swing(FR_);
  BOOST_TEST((clock.in_swing(RL_) && !clock.in_swing(RR_)));
}

// A foot that lifted off in the middle of its swing time would have too little time to land.
BOOST_FIXTURE_TEST_CASE(released_foot_lifts_off_in_its_next_cycle, ClockFixture) {
  stop = true;
  run(0.1 * kPeriod + 0.5 * timing.swing_time());  // FL skips its swing
  stop = false;
  BOOST_TEST(std::abs(time_until_swing(FL_) - (kPeriod - 0.5 * timing.swing_time())) < 3.0 * kDt);
  BOOST_TEST(clock.swing_progress(FL_) < 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
