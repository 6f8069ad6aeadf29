// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "gait/step_timing.hpp"
#include "walking_body.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

// A robot over the feet of its nominal stance, of which FL and RR begin to swing.
struct StepTimingFixture : WalkingBody {
  GaitClock clock;
  FeetMatrix feet;

  StepTimingFixture() {
    stand_over(Eigen::Vector2d::Zero());
    clock.start_swing(timing(), FL_);
    clock.advance(timing(), false, false, kDt);
  }
  // Put the feet where the middle of the nominal stance is `ahead` [m] of the body, world axes.
  void stand_over(const Eigen::Vector2d& ahead) {
    const Eigen::Rotation2Dd R(measured.yaw);
    feet = size.nominal_feet;
    feet.topRows<2>() = (R.toRotationMatrix() * size.nominal_feet.topRows<2>()).colwise() +
                        (measured.p_com + ahead);
  }
  GaitTiming timing() const { return {2.4 * size.time, 0.5, {0.0, 0.5, 0.5, 0.0}}; }
  double factor() const { return swing_time_factor(size, clock, timing(), feet, measured, body); }
  // Move the capture point by velocity alone, across the line between the stance feet.
  void push(double distance) {
    const Eigen::Vector2d line = (feet.col(FR_) - feet.col(RL_)).head<2>().normalized();
    measured.v_com = distance / size.time * Eigen::Vector2d(-line.y(), line.x());
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(gait_step_timing)

BOOST_FIXTURE_TEST_CASE(swing_of_a_robot_at_rest_keeps_its_time, StepTimingFixture) {
  BOOST_TEST(factor() == 1.0);
}

BOOST_FIXTURE_TEST_CASE(capture_point_along_the_line_keeps_the_time, StepTimingFixture) {
  measured.v_com = (feet.col(FR_) - feet.col(RL_)).head<2>() / size.time;
  BOOST_TEST(factor() == 1.0);
}

BOOST_FIXTURE_TEST_CASE(capture_point_is_within_reach_at_the_shorter_touchdown, StepTimingFixture) {
  for (const double share : {0.4, 0.5}) {
    for (const double sign : {1.0, -1.0}) {
      push(sign * share * size.height);
      const double time = factor() * clock.time_to_touchdown(FL_);
      const double at_touchdown = share * size.height * std::exp(time / size.time);
      BOOST_TEST(at_touchdown == size.height, boost::test_tools::tolerance(1e-6));
    }
  }
}

// The clock that runs faster must not change the times from which the factor is computed.
BOOST_FIXTURE_TEST_CASE(factor_does_not_depend_on_the_factor_of_the_last_tick, StepTimingFixture) {
  push(0.4 * size.height);
  const double first = factor();
  BOOST_TEST(first < 0.9);
  for (int k = 0; k < 5; ++k) {
    GaitTiming shortened = timing();
    shortened.period *= factor();
    clock.advance(shortened, 0.0, false, kDt);
    BOOST_TEST(factor() == first, boost::test_tools::tolerance(0.1));
  }
}

BOOST_FIXTURE_TEST_CASE(swing_is_never_shorter_than_half, StepTimingFixture) {
  push(5.0 * size.height);
  BOOST_TEST(factor() == 0.5);
}

BOOST_FIXTURE_TEST_CASE(steady_walk_keeps_its_time, StepTimingFixture) {
  walk({0.8, 0.0, 0.0}, 5.0);
  // The stance has just begun: the body is half a stance behind the middle of its feet.
  stand_over(0.5 * clock.timing().stance_time() * body.v_world());
  BOOST_TEST(factor() == 1.0);
}

BOOST_FIXTURE_TEST_CASE(feet_that_all_stand_keep_the_time, StepTimingFixture) {
  clock.start();
  push(5.0 * size.height);
  BOOST_TEST(factor() == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
