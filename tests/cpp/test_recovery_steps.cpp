// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "capture_point_robot.hpp"
#include "gait/walk_planner.hpp"
#include "reference/capture_margin.hpp"
#include "reference/planner_input.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

// A robot that has stood for a second without a commanded velocity.
struct PushedStand : CapturePointRobot {
  WalkPlanner planner{robot};
  int lost_leg = -1;

  PushedStand() { run(1.0); }
  void run(double seconds) {
    for (int k = 0; k < seconds / kDt - 0.5; ++k) {
      planner.plan(make_planner_input(state, gains, dynamics, kDt, 0.0, robot.mass(), lost_leg),
                   reference);
    }
  }
  // Return whether the robot steps in the first tick with its capture point `beyond` [m] to the
  // right of the right feet.
  bool steps_at(double beyond) {
    move_capture_point_right(beyond);
    run(kDt);
    return planner.walking();
  }
  void lift_left_feet() { state.contact << 1.0, 0.0, 1.0, 0.0; }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(recovery_steps)

BOOST_FIXTURE_TEST_CASE(robot_steps_when_the_capture_point_leaves_the_support, PushedStand) {
  BOOST_TEST(!steps_at(-0.005));
  BOOST_TEST(!reference.stepping);
  BOOST_TEST(steps_at(0.005));
  BOOST_TEST(reference.stepping);
}

// The capture point is in front of the middle: nearer to the line from front right to rear left.
BOOST_FIXTURE_TEST_CASE(pair_far_from_the_capture_point_lifts_off_at_once, PushedStand) {
  steps_at(0.005);
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool swings = leg == FL_ || leg == RR_;
    BOOST_TEST(reference.feet[leg].stance == !swings);
    BOOST_TEST(reference.feet[leg].load == (swings ? 0.0 : 1.0));
  }
}

BOOST_FIXTURE_TEST_CASE(first_foot_lands_near_the_capture_point, PushedStand) {
  steps_at(0.005);
  const double com = dynamics.p_world_com().y();
  const double capture = capture_point(dynamics).y() - com;
  for (const int leg : {FL_, RR_}) {
    const double moved =
        planner.stepping().footholds()(1, leg) - dynamics.legs()[leg].p_world_contact.y();
    BOOST_TEST(moved < 0.8 * capture);  // both negative: to the right
  }
}

BOOST_FIXTURE_TEST_CASE(robot_that_tips_over_two_feet_steps_earlier, PushedStand) {
  const double margin = gains.recovery_margin * planner.stepping().size().height;
  BOOST_TEST(!steps_at(-0.9 * margin));
  lift_left_feet();
  BOOST_TEST(!steps_at(-1.1 * margin));
  BOOST_TEST(steps_at(-0.9 * margin));
}

BOOST_FIXTURE_TEST_CASE(negative_recovery_margin_delays_steps, PushedStand) {
  gains.recovery_margin = -0.1;
  const double beyond = 0.1 * planner.stepping().size().height;
  BOOST_TEST(!steps_at(0.9 * beyond));
  BOOST_TEST(steps_at(1.1 * beyond));
}

BOOST_FIXTURE_TEST_CASE(recovery_margin_of_minus_ten_switches_steps_off, PushedStand) {
  gains.recovery_margin = -10.0;
  lift_left_feet();
  BOOST_TEST(!steps_at(0.5));
}

BOOST_FIXTURE_TEST_CASE(robot_with_a_lost_leg_does_not_step, PushedStand) {
  lost_leg = RL_;
  BOOST_TEST(!steps_at(0.05));
}

BOOST_FIXTURE_TEST_CASE(robot_that_is_lifted_does_not_step, PushedStand) {
  state.contact.setZero();
  BOOST_TEST(!steps_at(0.05));
}

BOOST_FIXTURE_TEST_CASE(robot_does_not_step_while_its_sensors_are_checked, PushedStand) {
  planner.reset();
  run(0.2);
  BOOST_TEST(!steps_at(0.05));
}

BOOST_FIXTURE_TEST_CASE(robot_at_rest_in_its_nominal_stance_stands_again, PushedStand) {
  steps_at(0.005);
  set_com_velocity(Vector3::Zero());
  run(1.0);
  BOOST_TEST(!planner.walking());
  BOOST_TEST(!reference.stepping);
  for (const FootReference& foot : reference.feet) BOOST_TEST((foot.stance && foot.load == 1.0));
}

BOOST_AUTO_TEST_SUITE_END()
