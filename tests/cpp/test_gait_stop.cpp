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

// The middle of the feet and the velocity are given by hand; the body trajectory is at rest.
BOOST_FIXTURE_TEST_CASE(robot_steps_until_a_stand_can_stop_the_body, PlannedWalk) {
  struct Case {
    double offset, velocity;  // of the body from the middle of its feet [h], [h / sqrt(h/g)]
    bool stands;
  };
  const GaitSize& size = planner.stepping().size();
  const FeetMatrix feet =
      make_planner_input(state, gains, dynamics, kDt, kDelay, robot.mass(), lost_leg).p_feet;
  for (const Case& c : {Case{0.05, 0.04, true}, Case{0.0, 0.11, false}, Case{0.11, 0.0, false},
                        Case{0.11, -0.1, false}, Case{-0.05, 0.1, true}}) {
    state.v.setZero();
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    p_feet.reset();
    walk({}, 2.0);
    BOOST_REQUIRE(!planner.walking());
    walk({0.3, 0.0, 0.0}, 0.1);
    p_feet = feet.colwise() - c.offset * size.height * Vector3::UnitX();
    state.v[0] = c.velocity * size.height / size.time;
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    walk({}, 2.0);
    BOOST_TEST(planner.walking() != c.stands);
  }
}

BOOST_FIXTURE_TEST_CASE(gait_trot_steps_at_velocity_0, PlannedWalk) {
  planner.set_gait(gains, Gait::kTrot);
  walk({}, 2.0);
  BOOST_TEST((planner.walking() && reference.stepping));
  BOOST_TEST(planner.stepping().body().v_world().norm() == 0.0);
  run(1.5);  // no velocity is set any more
  expect_standing_reference();
}

BOOST_FIXTURE_TEST_CASE(robot_with_a_lost_leg_stands_when_its_other_feet_are_down, PlannedWalk) {
  walk({0.3, 0.0, 0.0}, 0.5);
  BOOST_TEST(planner.walking());
  while (swing_feet() == 0) walk({0.3, 0.0, 0.0}, kDt);
  lost_leg = RR_;
  walk({0.3, 0.0, 0.0}, kDt);
  BOOST_TEST(planner.walking());  // a pair is in the air
  walk({0.3, 0.0, 0.0}, 0.35);
  expect_standing_reference();
  walk({0.3, 0.0, 0.0}, 1.0);
  BOOST_TEST(!planner.walking());
}

BOOST_FIXTURE_TEST_CASE(lifted_robot_stands_and_walks_again_when_all_feet_carry, PlannedWalk) {
  walk({0.3, 0.0, 0.0}, 0.5);
  state.contact.setZero();
  walk({0.3, 0.0, 0.0}, 0.1);
  BOOST_TEST(planner.walking());  // as in a flying trot
  walk({0.3, 0.0, 0.0}, 0.15);
  expect_standing_reference();
  state.contact << 1.0, 1.0, 1.0, 0.0;
  walk({0.3, 0.0, 0.0}, 0.1);
  BOOST_TEST(!planner.walking());
  state.contact.setOnes();
  walk({0.3, 0.0, 0.0}, 0.1);
  BOOST_TEST(planner.walking());
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
