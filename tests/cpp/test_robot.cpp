// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "robot_states.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

namespace {

// Return the message of the surefoot::Error that `action` throws; empty if it throws none.
template <typename Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct SavedRobot {
  std::string path = "surefoot_test.robot";
  Robot robot = quadruped();
  SavedRobot() { robot.save(path); }
  ~SavedRobot() { std::remove(path.c_str()); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(robot)

BOOST_AUTO_TEST_CASE(missing_joint_error_lists_the_available_joints) {
  RobotConfig config = quadruped_config();
  config.joint_names[4] = "FL_tigh_joint";
  const std::string text = error_of([&] { Robot(quadruped().model(), config); });
  BOOST_TEST(contains(text, "FL_tigh_joint"));
  BOOST_TEST(contains(text, "did you mean 'FL_thigh_joint'"));
  BOOST_TEST(contains(text, "RR_calf_joint"));
}

BOOST_AUTO_TEST_CASE(a_foot_on_the_wrong_leg_is_refused) {
  RobotConfig config = quadruped_config();
  std::swap(config.foot_frames[0], config.foot_frames[1]);
  BOOST_TEST(contains(error_of([&] { Robot(quadruped().model(), config); }), "FL_foot"));
}

BOOST_AUTO_TEST_CASE(error_names_each_out_of_range_or_nan_gain) {
  for (const GainInfo& info : gain_table()) {
    for (const double bad : {info.maximum * 2.0 + 1.0, info.minimum - 1.0, std::nan("")}) {
      Gains gains;
      gains.*info.member = bad;
      BOOST_TEST(contains(error_of([&] { gains.validate(); }), std::string(info.name)));
    }
  }
}

BOOST_AUTO_TEST_CASE(default_gains_are_valid_and_found_by_name) {
  Gains gains;
  gains.validate();
  set_gain(gains, "com_kp_vertical", 123.0);
  BOOST_TEST(get_gain(gains, "com_kp_vertical") == 123.0);
  BOOST_TEST(contains(error_of([&] { set_gain(gains, "com_kp_up", 1.0); }), "com_kp_vertical"));
}

BOOST_AUTO_TEST_CASE(armature_of_the_configuration_is_in_the_model) {
  const Robot robot = quadruped();
  for (const int i : robot.motor_to_v()) BOOST_TEST(armature(robot)[i] == 0.005);
}

BOOST_AUTO_TEST_CASE(motor_torque_limit_falls_with_speed_only_while_driving) {
  const RobotConfig config = quadruped_config();
  BOOST_TEST(motor_torque_limit(config, 0, 10.0, 1.0) == 30.0);
  BOOST_TEST(motor_torque_limit(config, 0, 25.0, 1.0) == 0.0);
  BOOST_TEST(motor_torque_limit(config, 0, 40.0, 1.0) == 0.0);
  BOOST_TEST(motor_torque_limit(config, 0, 18.5, 1.0) == 15.0);
  BOOST_TEST(motor_torque_limit(config, 0, 18.5, -1.0) == 30.0);
}

BOOST_FIXTURE_TEST_CASE(saved_robot_file_loads_the_same_robot, SavedRobot) {
  const Robot copy = Robot::load(path);
  BOOST_TEST(copy.serialized_model() == robot.serialized_model());
  BOOST_TEST((copy.config().gains == robot.config().gains));
  BOOST_TEST((copy.config().q_lower == robot.config().q_lower));
  BOOST_TEST((copy.config().tau_max == robot.config().tau_max));
  BOOST_TEST(copy.config().joint_names[7] == robot.config().joint_names[7]);
  BOOST_TEST(copy.config().friction == robot.config().friction);
}

BOOST_FIXTURE_TEST_CASE(robot_file_version_error_names_both_versions, SavedRobot) {
  std::string content = read(path);
  content.replace(content.find(" 1\n"), 3, " 7\n");
  std::ofstream(path, std::ios::binary) << content;
  const std::string text = error_of([&] { Robot::load(path); });
  BOOST_TEST(contains(text, "got version 7"));
  BOOST_TEST(contains(text, "expected version 1"));
}

BOOST_FIXTURE_TEST_CASE(corrupt_or_truncated_robot_file_is_refused, SavedRobot) {
  const std::string content = read(path);
  std::string damaged = content;
  damaged[content.size() / 2] ^= 1;
  std::ofstream(path, std::ios::binary) << damaged;
  BOOST_TEST(contains(error_of([&] { Robot::load(path); }), "checksum"));
  std::ofstream(path, std::ios::binary) << content.substr(0, content.size() / 2);
  BOOST_TEST(contains(error_of([&] { Robot::load(path); }), "checksum"));
  std::ofstream(path, std::ios::binary) << "hello";
  BOOST_TEST(contains(error_of([&] { Robot::load(path); }), "not a robot file"));
}

BOOST_AUTO_TEST_SUITE_END()
