// SPDX-License-Identifier: BSD-3-Clause
#include "planned_walk.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(gait_stop)

BOOST_FIXTURE_TEST_CASE(robot_stops_with_its_feet_on_the_ground_after_velocity_0, PlannedWalk) {
  walk({0.3, 0.0, 0.0}, 1.0);
  double time = 0.0;
  for (; planner.walking() && time < 3.0; time += kDt) walk({}, kDt);
  BOOST_TEST(time > 0.1);
  BOOST_TEST(time < 1.5);
  expect_standing_reference();
  walk({0.0, 0.0, 0.3}, 0.01);
  BOOST_TEST(planner.walking());
}

BOOST_FIXTURE_TEST_CASE(robot_steps_until_its_feet_are_in_the_nominal_stance, PlannedWalk) {
  walk({0.3, 0.0, 0.0}, 1.0);
  state.q[robot.motor_to_q()[RL_1]] += 0.2;  // a foot that stands 5 cm off
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  walk({}, 3.0);
  BOOST_TEST(planner.walking());
  state = standing_state(robot);
  state.contact.setOnes();
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  walk({}, 1.0);
  BOOST_TEST(!planner.walking());
}

BOOST_FIXTURE_TEST_CASE(gait_trot_steps_at_velocity_0, PlannedWalk) {
  planner.set_gait(Gait::kTrot);
  run(2.0);
  BOOST_TEST((planner.walking() && reference.stepping));
  BOOST_TEST(planner.stepping().body().v_world().norm() == 0.0);
  planner.set_gait(Gait::kAuto);
  run(1.5);
  expect_standing_reference();
}

BOOST_FIXTURE_TEST_CASE(lost_leg_stops_the_walk_at_once, PlannedWalk) {
  walk({0.3, 0.0, 0.0}, 0.5);
  BOOST_TEST(planner.walking());
  lost_leg = RR_;
  walk({0.3, 0.0, 0.0}, kDt);
  expect_standing_reference();
  walk({0.3, 0.0, 0.0}, 1.0);
  BOOST_TEST(!planner.walking());
}

BOOST_FIXTURE_TEST_CASE(reset_forgets_the_walk_and_the_velocity, PlannedWalk) {
  walk({0.3, 0.0, 0.0}, 0.5);
  planner.reset();
  BOOST_TEST((!planner.walking() && planner.command().is_zero()));
  reference = Reference();
  run(0.1);
  expect_standing_reference();
}

BOOST_AUTO_TEST_SUITE_END()
