// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "low_level/low_state_check.hpp"
#include "quadruped.hpp"
#include "robot_states.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(low_state_check)

BOOST_AUTO_TEST_CASE(implausible_values_are_distinguished_from_non_finite_values) {
  const Robot robot = quadruped();
  const LowState good = resting_sample(robot, 0);
  BOOST_TEST((check_low_state(good, robot.config()) == Status::kOk));
  const auto with = [&](int field, float value) {
    LowState sample = good;
    std::array<float, 3> vector = {0.0F, value, 0.0F};
    if (field == 0) sample.imu.quaternion = {1.0F, 0.0F, value, 0.0F};
    if (field == 1) sample.imu.gyroscope = vector;
    if (field == 2) sample.imu.accelerometer = vector;
    if (field == 3) sample.motorState[11].q = value;
    if (field == 4) sample.motorState[0].dq = value;
    if (field == 5) sample.motorState[6].tauEst = value;
    return check_low_state(sample, robot.config());
  };
  for (int field = 0; field < 6; ++field) {
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY, 1e30F}) {
      BOOST_TEST((with(field, bad) == Status::kNonFinite));
    }
  }
  for (int field = 1; field < 6; ++field) {
    BOOST_TEST((with(field, 1000.0F) == Status::kImplausible));
    BOOST_TEST((with(field, -1000.0F) == Status::kImplausible));
  }
}

BOOST_AUTO_TEST_SUITE_END()
