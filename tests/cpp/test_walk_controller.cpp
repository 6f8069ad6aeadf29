// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cstring>

#include "random_disturbances.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/walk_controller.hpp"

using namespace surefoot;

namespace {

// A WalkController and the samples of a robot that does not move.
struct WalkControllerFixture {
  Robot robot = quadruped();
  WalkController controller{robot};
  LowState report = resting_sample(robot, 0);

  WalkControllerFixture() {
    for (int k = 0; k < 200; ++k) step();  // the sensor check of the first samples ends
    BOOST_TEST_REQUIRE((controller.status() == Status::kOk));
  }
  void step() {
    report.tick += 2;
    controller.update(report);
  }
  void walk(const WalkVelocity& velocity, double seconds) {
    for (int k = 0; k < seconds / 0.002 - 0.5; ++k) {
      controller.set_velocity(velocity);
      step();
      BOOST_REQUIRE(is_usable(controller.status()));
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(walk_controller)

BOOST_AUTO_TEST_CASE(walk_controller_at_velocity_0_sends_the_commands_of_a_stand_controller) {
  const Robot robot = quadruped();
  for (const double delay : {0.0, 0.01}) {
    WalkOptions options;
    options.tick.delay = delay;
    options.tick.power_limit = 150.0;
    StandController stand(robot, robot.config().gains, options.tick);
    WalkController walk(robot, robot.config().gains, options);
    RandomDisturbances disturbances(robot);
    int solved = 0;
    for (std::uint32_t tick = 1; tick <= 6000; ++tick) {
      const LowState& report = disturbances.report(tick);
      const LowCmd expected = stand.update(report);
      if (tick % 10 == 0) walk.set_velocity({});
      const LowCmd& command = walk.update(report);
      BOOST_REQUIRE(std::memcmp(&command, &expected, sizeof(LowCmd)) == 0);
      BOOST_REQUIRE((walk.status() == stand.status()));
      solved += is_usable(walk.status());
      if (tick == 4000) stand.declare_leg_lost(FL_), walk.declare_leg_lost(FL_);
      if (walk.status() == Status::kDamping) stand.reset(), walk.reset();
    }
    BOOST_TEST(solved > 3000);
  }
}

BOOST_FIXTURE_TEST_CASE(commanded_velocity_makes_the_robot_step, WalkControllerFixture) {
  BOOST_TEST((controller.planned_loads() == Eigen::Vector4d::Ones()));
  walk({0.5, 0.0, 0.0}, 1.0);
  BOOST_TEST((controller.walking() && controller.reference().stepping));
  BOOST_TEST(controller.reference_velocity().vx == 0.5);
  BOOST_TEST(controller.commanded_velocity().vx == 0.5);
  int swings = 0;
  for (int k = 0; k < 200; ++k) {
    walk({0.5, 0.0, 0.0}, 0.002);
    for (int leg = 0; leg < kLegs; ++leg) {
      if (controller.planned_loads()[leg] > 0.0) continue;
      ++swings;
      BOOST_REQUIRE(controller.solution().forces.col(leg).norm() < 1e-6);
    }
  }
  BOOST_TEST(swings > 100);
}

BOOST_FIXTURE_TEST_CASE(velocity_is_zero_after_velocity_timeout_without_a_command,
                        WalkControllerFixture) {
  walk({0.5, 0.0, 0.0}, 1.0);
  for (int k = 0; k < 245; ++k) step();
  BOOST_TEST(controller.commanded_velocity().vx == 0.5);
  for (int k = 0; k < 10; ++k) step();
  BOOST_TEST(controller.commanded_velocity().vx == 0.0);
  for (int k = 0; k < 1000; ++k) step();
  BOOST_TEST(!controller.walking());
  BOOST_TEST(controller.reference_velocity().vx == 0.0);
}

BOOST_FIXTURE_TEST_CASE(limit_of_a_commanded_velocity_is_reported, WalkControllerFixture) {
  controller.set_velocity({9.0, 0.0, 0.0});
  BOOST_TEST((controller.velocity_limit() == WalkLimit::kForward));
  BOOST_TEST(std::string(to_string(controller.velocity_limit())) == "forward");
  BOOST_TEST(controller.commanded_velocity().vx < 3.0);
  controller.set_velocity({std::nan(""), 0.0, 0.0});
  BOOST_TEST((controller.velocity_limit() == WalkLimit::kNotFinite));
}

BOOST_FIXTURE_TEST_CASE(lost_leg_ends_the_walk_and_reset_allows_it_again, WalkControllerFixture) {
  walk({0.5, 0.0, 0.0}, 0.5);
  controller.declare_leg_lost(RL_);
  walk({0.5, 0.0, 0.0}, 0.1);
  BOOST_TEST(!controller.walking());
  BOOST_TEST(!controller.reference().stepping);
  BOOST_TEST(controller.solution().forces.col(RL_).norm() < 1e-6);
  controller.reset();
  BOOST_TEST(controller.commanded_velocity().vx == 0.0);
  BOOST_TEST((!controller.walking() && !controller.reference().stepping));
  for (int k = 0; k < 200; ++k) step();
  BOOST_TEST((controller.status() == Status::kOk && !controller.walking()));
  walk({0.5, 0.0, 0.0}, 0.1);
  BOOST_TEST(controller.walking());
}

BOOST_AUTO_TEST_CASE(velocity_timeout_out_of_range_is_refused) {
  for (const double bad : {0.0, 61.0, std::nan("")}) {
    WalkOptions options;
    options.velocity_timeout = bad;
    BOOST_CHECK_EXCEPTION(WalkController(quadruped(), Gains(), options), Error,
                          [](const Error& error) {
                            return std::strstr(error.what(), "velocity_timeout") != nullptr;
                          });
  }
}

BOOST_AUTO_TEST_SUITE_END()
