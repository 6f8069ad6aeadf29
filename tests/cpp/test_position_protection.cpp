// SPDX-License-Identifier: BSD-3-Clause
// The SDK's two protections that use the joint limits.
#include <boost/test/unit_test.hpp>
#include <cstring>
#include <limits>

#include "quadruped.hpp"
#include "surefoot/safety.hpp"

using namespace surefoot;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// Hips whose limits on the right mirror those on the left, as on an Aliengo.
RobotConfig mirrored_hips() {
  RobotConfig config = quadruped_config();
  for (const int hip : {FL_0, RL_0}) {
    config.q_lower[hip] = -0.873;
    config.q_upper[hip] = 1.047;
  }
  for (const int hip : {FR_0, RR_0}) {
    config.q_lower[hip] = -1.047;
    config.q_upper[hip] = 0.873;
  }
  return config;
}

struct Joints {
  RobotConfig config = mirrored_hips();
  Safety safety{quadruped(config)};
  LowState state = init_low_state();
  Joints() {
    for (int i = 0; i < kMotors; ++i) set(i, config.q_standing[i]);
  }
  void set(int motor, double q) { state.motorState[motor].q = static_cast<float>(q); }
  int check_positions(double limit = 0.087) {
    return safety.position_protect(init_low_cmd(), state, limit);
  }
  float limited(int motor, float q) const {
    LowCmd cmd = init_low_cmd();
    cmd.motorCmd[motor].q = q;
    safety.position_limit(cmd);
    return cmd.motorCmd[motor].q;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(position_protection)

BOOST_AUTO_TEST_CASE(each_joint_trips_within_5_degrees_of_either_limit) {
  for (int i = 0; i < kMotors; ++i) {
    for (const double side : {-1.0, 1.0}) {
      Joints joints;
      const double end = side < 0.0 ? joints.config.q_lower[i] : joints.config.q_upper[i];
      joints.set(i, end - side * 0.0872);
      BOOST_TEST(joints.check_positions() == 1);
      BOOST_TEST(joints.safety.position_motor() == -1);
      joints.set(i, end - side * 0.0868);
      BOOST_TEST(joints.check_positions() == -1);
      BOOST_TEST(joints.safety.position_motor() == i);
      BOOST_TEST(joints.safety.position_angle() ==
                 static_cast<double>(joints.state.motorState[i].q));
    }
  }
}

BOOST_AUTO_TEST_CASE(angle_at_the_protection_limit_passes) {
  Joints joints;
  joints.config.q_lower[FL_2] = -2.5;
  joints.safety = Safety(quadruped(joints.config));
  joints.set(FL_2, -2.0);
  BOOST_TEST(joints.check_positions(0.5) == 1);
}

BOOST_AUTO_TEST_CASE(position_protection_trips_at_once_and_does_not_latch) {
  Joints joints;
  joints.set(RL_2, -2.69);
  BOOST_TEST(joints.check_positions() == -1);
  joints.set(RL_2, -1.6);
  BOOST_TEST(joints.check_positions() == 1);
  BOOST_TEST(joints.safety.position_motor() == -1);
  BOOST_TEST(joints.safety.position_angle() == 0.0);
}

BOOST_AUTO_TEST_CASE(margin_without_allowed_range_or_nan_margin_always_trips) {
  for (const double limit : {10.0, std::nan(""), HUGE_VAL}) {
    Joints joints;
    BOOST_TEST(joints.check_positions(limit) == -1);
    BOOST_TEST(joints.safety.position_motor() == 0);
  }
}

BOOST_AUTO_TEST_CASE(non_finite_angle_trips) {
  for (const float bad : {kNan, kInf, -kInf}) {
    Joints joints;
    joints.state.motorState[RR_1].q = bad;
    BOOST_TEST(joints.check_positions(0.0) == -1);
    BOOST_TEST(joints.safety.position_motor() == RR_1);
  }
  Joints joints;
  for (int slot = kMotors; slot < kMotorSlots; ++slot) joints.state.motorState[slot].q = kNan;
  BOOST_TEST(joints.check_positions() == 1);
}

BOOST_AUTO_TEST_CASE(position_commands_are_clamped_to_each_joints_range) {
  const Joints joints;
  for (int i = 0; i < kMotors; ++i) {
    const auto lower = static_cast<float>(joints.config.q_lower[i]);
    const auto upper = static_cast<float>(joints.config.q_upper[i]);
    BOOST_TEST(joints.limited(i, 5.0F) == upper);
    BOOST_TEST(joints.limited(i, -5.0F) == lower);
    BOOST_TEST(joints.limited(i, 9.9e8F) == upper);
    BOOST_TEST(joints.limited(i, 0.5F * (lower + upper)) == 0.5F * (lower + upper));
  }
  BOOST_TEST(joints.limited(FL_0, 2.0F) == 1.047F);
  BOOST_TEST(joints.limited(FR_0, 2.0F) == 0.873F);
}

BOOST_AUTO_TEST_CASE(stop_values_and_non_finite_positions_are_not_clamped) {
  const Joints joints;
  for (const float q : {static_cast<float>(PosStopF), 1e9F, -1e9F, kInf, -kInf}) {
    BOOST_TEST(joints.limited(FR_2, q) == q);
  }
  BOOST_TEST(std::isnan(joints.limited(FR_2, kNan)));
}

BOOST_AUTO_TEST_CASE(only_positions_of_the_twelve_motors_are_clamped) {
  const Joints joints;
  LowCmd cmd = init_low_cmd();
  for (int i = 0; i < kMotorSlots; ++i) {
    cmd.motorCmd[i] = {kModeDamping, i < kMotors ? -1.0F : 50.0F, 900.0F, 800.0F, -7.0F, kNan, {}};
  }
  cmd.motorCmd[FR_1].q = 50.0F;
  LowCmd expected = cmd;
  for (int i = 0; i < kMotors; ++i) expected.motorCmd[i].q = joints.limited(i, cmd.motorCmd[i].q);
  joints.safety.position_limit(cmd);
  BOOST_TEST(cmd.motorCmd[FR_1].q == 3.0F);
  BOOST_TEST(std::memcmp(&cmd, &expected, sizeof(LowCmd)) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
