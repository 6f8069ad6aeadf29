// SPDX-License-Identifier: BSD-3-Clause
// Judgement of a robot with its model in hand, and .robot files under other locales.
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <fstream>
#include <locale>
#include <pinocchio/multibody.hpp>
#include <sstream>

#include "quadruped.hpp"
#include "surefoot/error.hpp"

using namespace surefoot;

namespace {

using Edit = void (*)(pinocchio::Model&, RobotConfig&);

std::string refusal(Edit edit) {
  pinocchio::Model model = quadruped().model();
  RobotConfig config = quadruped_config();
  edit(model, config);
  try {
    Robot(model, config);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

void check_refused(Edit edit, const std::string& name, const std::string& words) {
  const std::string text = refusal(edit);
  BOOST_TEST_CONTEXT(text) {
    BOOST_TEST((text.find(name) != std::string::npos));
    BOOST_TEST((text.find(words) != std::string::npos));
  }
}

pinocchio::Inertia& body(pinocchio::Model& model, const char* joint) {
  return model.inertias[model.getJointId(joint)];
}

void set_moments(pinocchio::Inertia& inertia, double xx, double yy, double zz) {
  inertia = pinocchio::Inertia(inertia.mass(), inertia.lever(), Vector3(xx, yy, zz).asDiagonal());
}

// A locale as the German one, made here because the machine may not have it.
struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

struct CommaLocale {
  std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation));
  ~CommaLocale() { std::locale::global(before); }
};

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(robot_checks)

BOOST_AUTO_TEST_CASE(moving_body_without_mass_or_with_impossible_inertia_is_named) {
  check_refused([](auto& m, auto&) { body(m, "FL_calf_joint").mass() = 0.0; }, "FL_calf_joint",
                "mass: got 0 kg");
  check_refused([](auto& m, auto&) { body(m, "FL_calf_joint").mass() = -1.0; }, "FL_calf_joint",
                "mass: got -1 kg");
  check_refused([](auto& m, auto&) { set_moments(body(m, "RR_hip_joint"), 1e-3, 1e-3, 3e-3); },
                "RR_hip_joint", "above the sum of the other two");
  check_refused([](auto& m, auto&) { set_moments(body(m, "RR_hip_joint"), -1e-3, 1e-3, 1e-3); },
                "RR_hip_joint", "moments > 0");
  check_refused([](auto& m, auto&) { set_moments(body(m, "RR_hip_joint"), 1e-9, 1e-9, 1e-9); },
                "RR_hip_joint", "(1 mm)^2");
  check_refused([](auto& m, auto&) { set_moments(body(m, "RR_hip_joint"), 9.0, 9.0, 9.0); },
                "RR_hip_joint", "(2 m)^2");
  check_refused([](auto& m, auto&) { body(m, "FR_hip_joint").lever().z() = 40.0; }, "FR_hip_joint",
                "centre of mass");
}

BOOST_AUTO_TEST_CASE(second_free_flyer_is_refused) {
  check_refused(
      [](auto& m, auto&) {
        m.addJoint(1, pinocchio::JointModelFreeFlyer(), pinocchio::SE3::Identity(), "second");
      },
      "second", "one free-flyer at the root");
}

BOOST_AUTO_TEST_CASE(foot_in_a_quadrant_of_another_leg_is_refused) {
  check_refused(
      [](auto& m, auto&) {
        for (const char* name : {"FR_hip_joint", "FL_hip_joint", "RR_hip_joint", "RL_hip_joint"}) {
          m.jointPlacements[m.getJointId(name)].translation().y() *= -1.0;
          m.jointPlacements[m.getJointId(name) + 1].translation().y() *= -1.0;
        }
      },
      "FR_foot", "front right");
}

BOOST_AUTO_TEST_CASE(turned_axis_is_refused) {
  check_refused(
      [](auto& m, auto&) {
        m.jointPlacements[m.getJointId("RL_thigh_joint")].rotation() =
            Eigen::AngleAxisd(M_PI, Vector3::UnitZ()).toRotationMatrix();
      },
      "RL_thigh_joint", "axis: got (");
}

BOOST_AUTO_TEST_CASE(limits_and_radius_that_no_robot_has_are_refused) {
  check_refused([](auto&, auto& c) { c.foot_radius = 0.0; }, "foot radius", "above 0");
  check_refused([](auto&, auto& c) { c.q_upper[4] = 1e6; }, "FL_thigh_joint", "within one turn");
  check_refused([](auto&, auto& c) { c.q_standing[4] = 45.0; }, "FL_thigh_joint",
                "looks like degrees");
  check_refused([](auto&, auto& c) { c.tau_max[4] = 1e6; }, "FL_thigh_joint", "20 times");
  check_refused([](auto&, auto& c) { c.no_load_speed[5] = 1e6; }, "FL_calf_joint", "200 rad/s");
}

BOOST_AUTO_TEST_CASE(unusual_robot_is_accepted_with_doubts) {
  BOOST_TEST(quadruped().doubts().empty());
  pinocchio::Model model = quadruped().model();
  model.jointPlacements[model.getJointId("FR_calf_joint")].translation().z() -= 0.03;
  const Robot robot(model, quadruped_config());
  BOOST_TEST_REQUIRE(robot.doubts().size() == 2u);
  BOOST_TEST((robot.doubts()[0].find("heights of the feet") != std::string::npos));
  BOOST_TEST((robot.doubts()[1].find("'FR_foot' and 'FL_foot'") != std::string::npos));
}

BOOST_AUTO_TEST_CASE(weak_motor_is_accepted_with_a_doubt) {
  RobotConfig config = quadruped_config();
  config.tau_max[5] = 0.5;
  const Robot robot = quadruped(config);
  BOOST_TEST_REQUIRE(robot.doubts().size() == 1u);
  BOOST_TEST((robot.doubts()[0].find("torque limit of FL_calf_joint") != std::string::npos));
}

BOOST_AUTO_TEST_CASE(robot_file_is_the_same_under_a_locale_with_decimal_comma) {
  const Robot robot = quadruped();
  robot.save("point.robot");
  {
    const CommaLocale comma;
    std::ostringstream shown;
    shown << 1234.5;
    BOOST_TEST_REQUIRE(shown.str() == "1.234,5");
    robot.save("comma.robot");
    BOOST_TEST(Robot::load("point.robot").serialized_model() == robot.serialized_model());
    BOOST_TEST(Robot::load("comma.robot").config().friction == robot.config().friction);
  }
  BOOST_TEST((read("comma.robot") == read("point.robot")));
  std::remove("comma.robot");
  std::remove("point.robot");
}

BOOST_AUTO_TEST_CASE(names_with_spaces_and_quotes_survive_a_robot_file) {
  pinocchio::Model model = quadruped().model();
  RobotConfig config = quadruped_config();
  config.foot_frames[0] = R"(front "right" \ foot)";
  model.frames[model.getFrameId("FR_foot")].name = config.foot_frames[0];
  Robot(model, config).save("spaces.robot");
  BOOST_TEST(Robot::load("spaces.robot").config().foot_frames[0] == config.foot_frames[0]);
  std::remove("spaces.robot");
}

BOOST_AUTO_TEST_SUITE_END()
