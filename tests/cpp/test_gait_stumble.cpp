// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "gait/stumble.hpp"
#include "gait/swing_clearance.hpp"
#include "quadruped.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

struct StumbleFixture {
  GaitSize size{quadruped()};
  Stumble stumble{size};
  SwingFoot foot;  // of a swing ahead, high above the ground, without error

  StumbleFixture() {
    foot.p_reference = foot.p = Vector3(1.0, 0.2, 0.05);
    foot.v_reference = foot.v = Vector3(0.6, 0.0, -0.2) * size.speed;
    foot.height = 0.15 * size.height;
    foot.contact = 0.0;
    update(0.1);  // it has left the ground
  }
  // A face stops the foot ahead; it still moves down with its reference.
  void hit_a_face() {
    foot.v.x() = 0.0;
    foot.p_reference.x() = foot.p.x() + 0.07 * size.height;
    foot.contact = 1.0;
  }
  // The top of a step stops the foot in both directions.
  void land_on_a_step() {
    foot.v.setZero();
    foot.p_reference = foot.p + size.height * Vector3(0.07, 0.0, -0.04);
    foot.contact = 1.0;
  }
  double update(double progress = 0.7) { return stumble.update(FR_, foot, progress, kDt); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_stumble)

BOOST_FIXTURE_TEST_CASE(foot_that_follows_its_reference_is_stopped_by_nothing, StumbleFixture) {
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kNone));
  foot.contact = 1.0;  // vibration, or the last of the lift-off
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kNone));
  foot.p_reference.x() += 0.03 * size.height;  // the lag of a fast swing
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kNone));
}

BOOST_FIXTURE_TEST_CASE(face_of_a_step_is_an_obstacle_with_and_without_contact_confidence,
                        StumbleFixture) {
  hit_a_face();
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kObstacle));
  foot.contact = 0.0;
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kObstacle));
}

BOOST_FIXTURE_TEST_CASE(top_of_a_step_is_ground, StumbleFixture) {
  land_on_a_step();
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kGround));
}

// Friction stops a foot ahead before a soft sole stops it on its way down.
BOOST_FIXTURE_TEST_CASE(foot_near_the_ground_lands_whatever_stops_it, StumbleFixture) {
  hit_a_face();
  foot.height = 0.03 * size.height;
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kGround));
}

BOOST_FIXTURE_TEST_CASE(rising_foot_does_not_land, StumbleFixture) {
  land_on_a_step();
  foot.v_reference.z() = 0.2 * size.speed;
  BOOST_TEST((judge_swing_contact(foot, size) == SwingContact::kObstacle));
}

BOOST_FIXTURE_TEST_CASE(foot_at_a_face_lifts_from_a_point_behind_it_and_is_not_in_contact,
                        StumbleFixture) {
  hit_a_face();
  BOOST_TEST(update() == 0.0);
  BOOST_TEST((stumble.lifting(FR_) && stumble.begins(FR_) && stumble.any()));
  BOOST_TEST(stumble.p_start(FR_).x() < foot.p.x() - 0.01 * size.height);
  BOOST_TEST(stumble.p_start(FR_).z() == foot.p.z());
  BOOST_TEST((stumble.rises(FR_) && !stumble.lifting(FL_)));
  BOOST_TEST(update() == 0.0);
  BOOST_TEST((stumble.lifting(FR_) && !stumble.begins(FR_)));
}

// A saturated motor leaves a foot behind its reference; the foot bounces off a face at once.
BOOST_FIXTURE_TEST_CASE(foot_stumbles_only_after_it_has_touched_something, StumbleFixture) {
  hit_a_face();
  foot.contact = 0.0;
  update();
  BOOST_TEST(!stumble.lifting(FR_));
  foot.contact = 1.0;
  foot.p_reference = foot.p;  // the first tick of the contact
  update();
  BOOST_TEST(!stumble.lifting(FR_));
  hit_a_face();
  foot.contact = 0.0;
  update();
  BOOST_TEST(stumble.lifting(FR_));
}

// After a push the swing is short, and the confidence falls late.
BOOST_FIXTURE_TEST_CASE(contact_that_lasts_since_the_lift_off_is_no_stumble, StumbleFixture) {
  stumble.end(FR_);
  hit_a_face();
  for (int k = 0; k < 50; ++k) update();
  BOOST_TEST(!stumble.lifting(FR_));
}

BOOST_FIXTURE_TEST_CASE(lift_ends_when_the_foot_lands_on_the_step, StumbleFixture) {
  hit_a_face();
  update();
  foot.contact = 0.0;
  foot.v = foot.v_reference;
  foot.p_reference = foot.p;
  while (stumble.progress(FR_) < 0.7) BOOST_REQUIRE(update() == 0.0);
  land_on_a_step();
  BOOST_TEST(update() == 1.0);
  BOOST_TEST(!stumble.lifting(FR_));
}

BOOST_FIXTURE_TEST_CASE(lift_that_meets_nothing_ends_after_its_time, StumbleFixture) {
  hit_a_face();
  update();
  foot.contact = 0.0;
  foot.v = foot.v_reference;
  foot.p_reference = foot.p;
  int ticks = 0;
  for (; stumble.lifting(FR_); ++ticks) update();
  BOOST_TEST(std::abs(ticks * kDt - stumble.time()) < 2.0 * kDt);
}

BOOST_FIXTURE_TEST_CASE(foot_at_a_wall_gives_up_after_two_lifts, StumbleFixture) {
  int lifts = 0;
  hit_a_face();
  for (int k = 0; k < 1000; ++k) {
    update();
    lifts += stumble.begins(FR_);
  }
  BOOST_TEST(lifts == 2);
  BOOST_TEST(!stumble.lifting(FR_));
  stumble.end(FR_);  // the next swing may stumble again
  foot.contact = 0.0;
  update(0.1);
  foot.contact = 1.0;
  update();
  BOOST_TEST(stumble.lifting(FR_));
}

BOOST_FIXTURE_TEST_CASE(feet_that_lift_off_do_not_stumble, StumbleFixture) {
  hit_a_face();
  update(0.1);
  BOOST_TEST(!stumble.lifting(FR_));
}

BOOST_FIXTURE_TEST_CASE(clearance_stays_until_the_rear_feet_have_passed, StumbleFixture) {
  SwingClearance clearance(size);
  clearance.land(0.05 * size.height);  // soft soles
  BOOST_TEST(clearance.extra() == 0.0);
  clearance.land(-0.15 * size.height);  // down a step
  BOOST_TEST(std::abs(clearance.extra() - 0.15 * size.height) < 1e-12);
  clearance.stumble();
  BOOST_TEST(clearance.extra() > 0.15 * size.height);
  clearance.advance(2.0 * size.height, 1.0);
  BOOST_TEST(clearance.extra() > 0.0);
  clearance.advance(2.0 * size.height, 1.0);
  BOOST_TEST(clearance.extra() == 0.0);
}

BOOST_AUTO_TEST_SUITE_END()
