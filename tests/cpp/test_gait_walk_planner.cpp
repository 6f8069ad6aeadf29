// SPDX-License-Identifier: BSD-3-Clause
#include "planned_walk.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(gait_walk_planner)

BOOST_FIXTURE_TEST_CASE(robot_without_a_commanded_velocity_stands, PlannedWalk) {
  run(2.0);
  expect_standing_reference();
}

BOOST_FIXTURE_TEST_CASE(robot_stands_while_its_sensors_are_checked, PlannedWalk) {
  planner.reset();
  walk({0.3, 0.0, 0.0}, 0.29);
  BOOST_TEST(!planner.walking());
  walk({0.3, 0.0, 0.0}, 0.02);
  BOOST_TEST(planner.walking());
}

BOOST_FIXTURE_TEST_CASE(feet_of_a_walking_robot_swing_in_pairs, PlannedWalk) {
  std::array<int, 5> ticks{};
  for (int k = 0; k < 1000; ++k) {
    walk({0.3, 0.0, 0.0}, kDt);
    ++ticks[swing_feet()];
    BOOST_REQUIRE((reference.stepping && planner.walking()));
    for (const FootReference& foot : reference.feet) {
      BOOST_REQUIRE(foot.min_contact == 1.0);
      BOOST_REQUIRE((foot.stance || foot.load == 0.0));
    }
  }
  BOOST_TEST(ticks[2] > 400);
  BOOST_TEST((ticks[1] == 0 && ticks[3] == 0));
  BOOST_TEST(planner.stepping().body().velocity().vx == 0.3);
}

// The swing foot is planned for the time when the command acts.
BOOST_FIXTURE_TEST_CASE(swing_foot_moves_towards_its_foothold, PlannedWalk) {
  state.v[0] = 0.3;
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  walk({0.3, 0.0, 0.0}, 1.0);
  while (planner.stepping().clock().swing_progress(FL_) < 0.4) walk({0.3, 0.0, 0.0}, kDt);
  const FootReference before = reference.feet[FL_];
  walk({0.3, 0.0, 0.0}, kDt);
  const FootReference& foot = reference.feet[FL_];
  BOOST_TEST(((foot.p_world - before.p_world) / kDt - foot.v_world).norm() < 0.1);
  const FeetMatrix stand = contact_points(dynamics);
  BOOST_TEST(foot.p_world.z() - stand(2, FL_) > 0.5 * gains.swing_height * robot.q_standing()[2]);
  BOOST_TEST(foot.v_world.x() > 0.0);
  BOOST_TEST(planner.stepping().footholds()(0, FL_) > stand(0, FL_));
  // A stance foot stays where it is.
  BOOST_TEST((reference.feet[FR_].p_world - stand.col(FR_)).norm() == 0.0);
  BOOST_TEST(reference.feet[FR_].v_world.norm() == 0.0);
}

// On a lateral slope one foot may carry next to nothing.
BOOST_FIXTURE_TEST_CASE(walk_begins_when_one_foot_carries_nothing_for_some_time, PlannedWalk) {
  state.contact[FL_] = 0.0;
  walk({0.3, 0.0, 0.0}, 0.4);
  BOOST_TEST(planner.walking());
}

BOOST_AUTO_TEST_SUITE_END()
