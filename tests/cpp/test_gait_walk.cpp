// SPDX-License-Identifier: BSD-3-Clause
#include "planned_walk.hpp"

using namespace surefoot;

namespace {

// The gait walk of a robot that moves as planned: stance feet stay, swing feet follow the
// reference. Its joints do not move.
struct GaitWalkFixture : PlannedWalk {
  std::array<int, 5> ticks{};      // by number of swing feet
  Vector3 push = Vector3::Zero();  // [m/s] velocity beyond the planned one, world axes

  GaitWalkFixture() {
    planner.set_gait(gains, Gait::kWalk);
    p_feet = contact_points(dynamics);
  }
  void count(const WalkVelocity& velocity, double seconds) {
    ticks = {};
    for (int k = 0; k < seconds / kDt - 0.5; ++k) {
      walk(velocity, kDt);
      follow();
      ++ticks[swing_feet()];
    }
  }
  void follow() {
    for (int leg = 0; leg < kLegs; ++leg) {
      const FootReference& foot = reference.feet[leg];
      if (!foot.stance) p_feet->col(leg) = foot.p_world;
    }
    const Vector3 v = reference.v_com + push + 5.0 * (reference.p_com - dynamics.p_world_com());
    state.q.head<2>() += kDt * v.head<2>();
    state.v.head<3>() = dynamics.R_world_base().transpose() * v;
    dynamics.update(state.q, state.v, Vector3::UnitZ());
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_walk)

BOOST_FIXTURE_TEST_CASE(feet_of_a_walk_swing_one_at_a_time, GaitWalkFixture) {
  count({0.1, 0.0, 0.0}, 5.0);
  BOOST_TEST((reference.stepping && planner.walking()));
  BOOST_TEST(ticks[1] > 1000);  // a foot that stays on the ground has touched down early after 60 %
  BOOST_TEST(ticks[2] + ticks[3] + ticks[4] == 0);
}

BOOST_FIXTURE_TEST_CASE(body_shifts_before_the_first_foot_lifts_off, GaitWalkFixture) {
  double time = 0.0;
  for (; swing_feet() == 0 && time < 2.0; time += kDt) walk({0.1, 0.0, 0.0}, kDt);
  BOOST_TEST(time > planner.stepping().size().time);
  BOOST_TEST(planner.stepping().sway().p().norm() > 0.0);
}

BOOST_FIXTURE_TEST_CASE(walk_stands_at_velocity_0, GaitWalkFixture) {
  walk({}, 1.0);
  expect_standing_reference();
  walk({0.1, 0.0, 0.0}, 0.1);
  BOOST_TEST(planner.walking());
}

BOOST_FIXTURE_TEST_CASE(gait_changes_while_the_robot_walks, GaitWalkFixture) {
  const WalkVelocity velocity{0.1, 0.0, 0.0};
  for (const Gait gait : {Gait::kAuto, Gait::kWalk, Gait::kTrot}) {
    planner.set_gait(gains, gait);
    count(velocity, 1.0);
    BOOST_TEST(planner.walking());
    count(velocity, 2.0);
    const bool walks = gait == Gait::kWalk;
    BOOST_TEST((ticks[1] > 0) == walks);
    BOOST_TEST((ticks[2] > 0) == !walks);
  }
}

// Feet stand in between: the walk never has two feet in the air.
BOOST_FIXTURE_TEST_CASE(order_changes_with_the_direction_of_motion, GaitWalkFixture) {
  for (const WalkVelocity& velocity :
       {WalkVelocity{0.15, 0.0, 0.0}, WalkVelocity{0.0, 0.15, 0.0}, WalkVelocity{0.0, 0.0, 0.4}}) {
    count(velocity, 3.0);
    BOOST_TEST(ticks[1] > 600);  // of 1500; early touchdowns shorten the swings of a robot at rest
    BOOST_TEST(ticks[2] + ticks[3] + ticks[4] == 0);
  }
}

BOOST_FIXTURE_TEST_CASE(pushed_walk_trots_and_then_walks_again, GaitWalkFixture) {
  const WalkVelocity velocity{0.1, 0.0, 0.0};
  count(velocity, 3.0);
  push.y() = 0.5;
  count(velocity, 0.3);
  BOOST_TEST(ticks[2] > 20);
  push.setZero();
  count(velocity, 2.0);
  count(velocity, 2.0);
  BOOST_TEST((ticks[1] > 400 && ticks[2] == 0));
}

// All feet stand before a trot becomes a walk. A robot that tips over two feet must step instead:
// the others may never stand.
BOOST_FIXTURE_TEST_CASE(pushed_trot_becomes_a_walk_when_the_push_is_braked, GaitWalkFixture) {
  planner.set_gait(gains, Gait::kTrot);
  count({}, 1.0);
  push.y() = 0.5;
  count({}, 0.05);
  planner.set_gait(gains, Gait::kWalk);
  state.contact[FR_] = state.contact[RR_] = 0.0;
  count({0.02, 0.0, 0.0}, 0.3);
  count({0.02, 0.0, 0.0}, 0.3);
  BOOST_TEST(ticks[2] > 40);
  push.setZero();
  state.contact.setOnes();
  count({0.02, 0.0, 0.0}, 2.0);
  count({0.02, 0.0, 0.0}, 2.0);
  BOOST_TEST((ticks[1] > 400 && ticks[2] == 0));
}

// The zero-moment point that brakes the push stays inside the support polygon.
BOOST_FIXTURE_TEST_CASE(walk_goes_on_if_its_stance_feet_can_brake_the_push, GaitWalkFixture) {
  const WalkVelocity velocity{0.1, 0.0, 0.0};
  count(velocity, 3.0);
  push.x() = 0.1;
  count(velocity, 0.5);
  push.setZero();
  count(velocity, 1.0);
  BOOST_TEST((ticks[1] > 200 && ticks[2] == 0));
}

// All feet stand while the order changes, so the body must be slow before.
BOOST_FIXTURE_TEST_CASE(walk_slows_down_before_it_changes_its_order, GaitWalkFixture) {
  count({0.2, 0.0, 0.0}, 4.0);
  const WalkOrder order = planner.stepping().pattern().order;
  double speed = 1.0;
  for (int k = 0; k < 2000 && planner.stepping().pattern().order == order; ++k) {
    count({0.0, 0.2, 0.0}, kDt);
    speed = planner.stepping().body().v_world().norm();
  }
  BOOST_TEST((planner.stepping().pattern().order != order));
  BOOST_TEST(speed < 0.3 * gains.walk_gait_speed * planner.stepping().size().speed);
}

BOOST_FIXTURE_TEST_CASE(height_and_attitude_last_from_stand_to_trot_to_stand, PlannedWalk) {
  planner.stand().set_target({0.0, 0.0, -0.02, 0.0, 0.1, 0.0});
  run(2.0);
  const auto expect_offset = [&] {
    const BodyReference offset = planner.stand().motion().relative_pose();
    BOOST_TEST(std::abs(offset.height + 0.02) < 1e-3);
    BOOST_TEST(std::abs(offset.pitch - 0.1) < 1e-3);
  };
  expect_offset();
  walk({0.1, 0.0, 0.0}, 1.0);
  BOOST_TEST(planner.walking());
  expect_offset();
  walk({}, 2.5);
  BOOST_TEST(!planner.walking());
  expect_offset();
}

BOOST_AUTO_TEST_SUITE_END()
