// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "gait/foot_contacts.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

// FR and RL stand at first, FL and RR lift off after 0.04 s.
struct ContactsFixture {
  GaitClock clock;
  GaitTiming timing;
  FootContacts contacts;
  Eigen::Vector4d contact = Eigen::Vector4d::Ones();
  std::array<bool, kLegs> lifting{};
  int lift_offs = 0, landings = 0, losses = 0;  // of FL

  ContactsFixture() {
    timing.period = 0.4;
    timing.duty = 0.6;
    clock.start();
    contacts.start();
  }
  void tick() {
    const bool was_in_stance = contacts.in_stance(FL_);
    clock.advance(timing, contacts.late(clock, 0.0) ? 0.06 : 0.0, false, kDt);
    contacts.update(clock, contact, lifting, kDt);
    lift_offs += contacts.lifted_off(FL_);
    landings += !was_in_stance && contacts.in_stance(FL_);
    losses += contacts.lost(FL_);
  }
  void until(FootPhase phase) {
    for (int k = 0; contacts.phase(FL_) != phase; ++k, tick()) BOOST_REQUIRE(k < 1000);
  }
  void until_progress(double progress) {
    while (!clock.in_swing(FL_)) tick();
    while (clock.in_swing(FL_) && clock.swing_progress(FL_) < progress) tick();
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_contacts)

BOOST_FIXTURE_TEST_CASE(foot_that_lands_in_time_is_in_stance_again, ContactsFixture) {
  until(FootPhase::kSwing);
  BOOST_TEST((lift_offs == 1 && contacts.load(FL_) == 0.0));
  BOOST_TEST(
      (contacts.in_stance(FR_) && !contacts.in_stance(FL_) && !contacts.others_in_stance(RR_)));
  contact[FL_] = 0.0;
  until_progress(0.9);
  while (clock.in_swing(FL_)) {
    contact[FL_] = clock.swing_progress(FL_) > 0.95 ? 1.0 : 0.0;
    tick();
  }
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kStance));
  BOOST_TEST((lift_offs == 1 && landings == 1 && losses == 0));
  BOOST_TEST(!contacts.late(clock, 0.0));
}

// Contact at the start of a swing is the foot that still leaves the ground, or an obstacle.
BOOST_FIXTURE_TEST_CASE(foot_lands_early_only_in_the_last_part_of_its_swing, ContactsFixture) {
  until_progress(0.55);
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kSwing));  // in contact all the time
  until_progress(0.65);
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kEarlyTouchdown));
  BOOST_TEST(landings == 1);
  contact[FL_] = 0.5;  // it stays down
  until_progress(0.9);
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kEarlyTouchdown));
  BOOST_TEST(contacts.load(FL_) == 0.2);
  contact[FL_] = 1.0;
  until(FootPhase::kStance);
  BOOST_TEST((landings == 1 && lift_offs == 1));
}

BOOST_FIXTURE_TEST_CASE(late_foot_has_little_load_until_it_lands, ContactsFixture) {
  until(FootPhase::kSwing);
  contact[FL_] = 0.0;
  until(FootPhase::kLateTouchdown);
  BOOST_TEST((landings == 0 && losses == 0));
  for (int k = 0; k < 15; ++k) tick();
  BOOST_TEST(contacts.late(clock, 0.0));
  BOOST_TEST(contacts.load(FL_) == 0.1);
  contact[FL_] = 0.6;  // not sure yet
  tick();
  BOOST_TEST(contacts.late(clock, 0.0));
  contact[FL_] = 0.8;
  tick();
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kStance && landings == 1));
}

// A walk waits until a foot that has landed carries its full load.
BOOST_FIXTURE_TEST_CASE(foot_with_less_than_the_smallest_load_is_late, ContactsFixture) {
  until(FootPhase::kSwing);
  until(FootPhase::kStance);
  BOOST_TEST(contacts.load(FL_) < 1.0);
  BOOST_TEST((contacts.late(clock, 1.0) && !contacts.late(clock, 0.0)));
  for (int k = 0; k < 10; ++k) tick();
  BOOST_TEST(contacts.load(FL_) == 1.0);
  BOOST_TEST(!contacts.late(clock, 1.0));
}

BOOST_FIXTURE_TEST_CASE(foot_that_lifts_over_an_obstacle_swings_until_it_lands, ContactsFixture) {
  until(FootPhase::kSwing);
  contact[FL_] = 0.0;
  lifting[FL_] = true;
  while (clock.in_swing(FL_)) tick();
  for (int k = 0; k < 10; ++k) tick();
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kSwing && contacts.load(FL_) == 0.0));
  BOOST_TEST(lift_offs == 1);
  lifting[FL_] = false;
  contact[FL_] = 1.0;
  tick();
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kStance && contacts.landed(FL_)));
  tick();
  BOOST_TEST(!contacts.landed(FL_));
}

BOOST_FIXTURE_TEST_CASE(stance_foot_that_loses_the_ground_reaches_for_it, ContactsFixture) {
  contact[FR_] = contact[FL_] = 0.5;
  tick();
  BOOST_TEST(contacts.others_in_stance(-1));  // hysteresis
  contact[FL_] = 0.2;
  tick();
  BOOST_TEST((contacts.phase(FL_) == FootPhase::kLateTouchdown && losses == 1));
  BOOST_TEST((contacts.load(FL_) == 0.1 && contacts.late(clock, 0.0) && !contacts.in_stance(FL_)));
  tick();
  BOOST_TEST(losses == 1);
}

BOOST_FIXTURE_TEST_CASE(loads_ramp_within_20_ms_of_lift_off_and_touchdown, ContactsFixture) {
  double last = 1.0;
  while (!clock.in_swing(FL_)) {
    tick();
    BOOST_REQUIRE(std::abs(contacts.load(FL_) - last) <= kDt / 0.02 + 1e-9);
    const double left = clock.time_to_liftoff(FL_);
    if (left > 0.0) BOOST_REQUIRE(std::abs(contacts.load(FL_) - std::min(1.0, left / 0.02)) < 1e-9);
    last = contacts.load(FL_);
  }
  contact[FL_] = 0.0;
  until_progress(0.99);
  contact[FL_] = 1.0;
  until(FootPhase::kStance);
  const double landed = contacts.load(FL_);
  for (int k = 1; k <= 5; ++k) {
    tick();
    BOOST_TEST(std::abs(contacts.load(FL_) - landed - k * kDt / 0.02) < 1e-9);
  }
  for (int k = 0; k < 10; ++k) tick();
  BOOST_TEST(contacts.load(FL_) == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
