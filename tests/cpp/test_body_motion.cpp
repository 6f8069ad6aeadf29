// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dynamics/dynamics.hpp"
#include "reference/body_motion.hpp"
#include "reference/support_polygon.hpp"
#include "scenes.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

Vector6 vector_of(const BodyReference& r) {
  Vector6 v;
  v << r.x, r.y, r.height, r.roll, r.pitch, r.yaw;
  return v;
}

// The support frame of a robot that stands level is below its base.
struct Level {
  Robot robot;
  Gains gains;
  RobotState state = standing_state(robot);
  FeetMatrix feet = contact_points(robot, state.q);
  BodyMotion motion{robot};
  StanceKinematics legs{robot};
  double fastest = 0.0, fastest_turn = 0.0, hardest = 0.0;  // of what was seen
  Vector6 last_speed = Vector6::Zero();
  Level() : Level(quadruped()) {}
  explicit Level(const Robot& of) : robot(of) {
    legs.start_from(state.q);
    motion.latch({state.q.head<3>(), Quaternion::Identity()}, center_of_mass(robot, state.q),
                 state.q);
  }
  void run(double seconds) {
    for (int k = 0; k < seconds / kDt; ++k) {
      const Vector6 before = vector_of(motion.position());
      motion.step(gains, feet, -Vector3::UnitZ(), kDt);
      BOOST_REQUIRE(legs.solve(motion.p_base(), motion.R_base(), feet, Vector3::UnitZ()));
      const Vector6 speed = (vector_of(motion.position()) - before) / kDt;
      hardest = std::max(hardest, (speed - last_speed).head<3>().norm() / kDt);
      last_speed = speed;
      fastest = std::max(fastest, speed.head<3>().norm());
      fastest_turn = std::max(fastest_turn, speed.tail<3>().norm());
    }
  }
  // Least distance of a joint from its limits in the pose that is asked for now.
  double joint_room() const {
    double room = 1e9;
    for (int i = 0; i < kMotors; ++i) {
      const double q = legs.q()[robot.motor_to_q()[i]];
      room = std::min({room, q - robot.config().q_lower[i], robot.config().q_upper[i] - q});
    }
    return room;
  }
  // How far a hip has turned its leg under the trunk, in the pose that is asked for now.
  double hip_inward(int motor) const {
    const double q = legs.q()[robot.motor_to_q()[motor]];
    return motor / 3 % 2 == 1 ? -q : q;
  }
  double support_room() const {
    return SupportPolygon(feet, {true, true, true, true}).margin(motion.p_com().head<2>());
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(body_motion)

BOOST_FIXTURE_TEST_CASE(a_target_within_reach_is_reached_no_faster_than_the_gains_say, Level) {
  const BodyReference target{0.03, -0.02, -0.04, 0.1, -0.08, 0.15};
  motion.set_target(target);
  run(3.0);
  BOOST_TEST((vector_of(motion.position()) - vector_of(target)).norm() < 1e-4);
  BOOST_TEST((motion.status().limit == ReachLimit::kNone));
  BOOST_TEST(fastest <= gains.reference_speed + 1e-9);
  BOOST_TEST(fastest > 0.6 * gains.reference_speed);
  BOOST_TEST(hardest <= gains.reference_acceleration * (1.0 + 1e-6));
  BOOST_TEST(fastest_turn <= gains.reference_turn_speed + 1e-9);
  BOOST_TEST(fastest_turn > 0.9 * gains.reference_turn_speed);
  BOOST_TEST(motion.v_com().norm() == 0.0);
  BOOST_TEST(motion.w_base().norm() == 0.0);
}

// Sixty seconds of random requests, most of them beyond what a leg or the balance can do.
BOOST_FIXTURE_TEST_CASE(whatever_is_asked_speed_joints_and_support_stay_inside_their_limits,
                        Level) {
  std::srand(11);
  double joint = 1e9, support = 1e9;
  for (int request = 0; request < 60; ++request) {
    const Vector6 r = Vector6::Random();
    motion.set_target({0.15 * r[0], 0.15 * r[1], 0.12 * r[2], 0.5 * r[3], 0.5 * r[4], r[5]});
    for (int k = 0; k < 500; ++k) {
      run(kDt);
      joint = std::min(joint, joint_room());
      support = std::min(support, support_room());
    }
  }
  BOOST_TEST(fastest <= gains.reference_speed + 1e-9);
  BOOST_TEST(fastest > 0.6 * gains.reference_speed);
  BOOST_TEST(hardest <= gains.reference_acceleration * (1.0 + 1e-6));
  BOOST_TEST(fastest_turn <= gains.reference_turn_speed + 1e-9);
  BOOST_TEST(fastest_turn > 0.9 * gains.reference_turn_speed);
  // On several axes at once the way to a stop is a curve, and its end alone was looked at.
  BOOST_TEST(joint >= gains.reach_joint_margin - 2e-3);
  BOOST_TEST(joint < gains.reach_joint_margin + 0.01);
  BOOST_TEST(support >= gains.reach_support_margin - 1e-3);
  BOOST_TEST(support < gains.reach_support_margin + 0.01);
}

BOOST_FIXTURE_TEST_CASE(too_low_stops_at_a_knee_and_says_which, Level) {
  motion.set_target({0.0, 0.0, -0.25, 0.0, 0.0, 0.0});
  run(4.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kJoint));
  BOOST_TEST(motion.status().motor % 3 != 0);
  BOOST_TEST(motion.position().height < -0.05);
  BOOST_TEST(motion.position().height > -0.25);
  BOOST_TEST(joint_room() >= gains.reach_joint_margin - 1e-9);
  BOOST_TEST(joint_room() < gains.reach_joint_margin + 2e-3);
  BOOST_TEST(motion.v_com().norm() == 0.0);
}

BOOST_AUTO_TEST_CASE(sideways_it_stops_at_a_hip_that_may_turn_no_further_inward) {
  RobotConfig config = quadruped_config();
  config.hip_inward = 0.3;
  Level level(quadruped(config));
  level.motion.set_target({0.0, 0.0, 0.0, 0.45, 0.0, 0.0});
  level.run(4.0);
  const ReachStatus status = level.motion.status();
  BOOST_TEST((status.limit == ReachLimit::kJoint));
  BOOST_TEST(status.motor % 3 == 0);
  const double inward = level.gains.reach_joint_margin + level.hip_inward(status.motor);
  BOOST_TEST(inward <= 0.3 + 1e-9);
  BOOST_TEST(inward > 0.3 - 2e-3);
}

BOOST_FIXTURE_TEST_CASE(too_low_stops_where_a_foot_comes_near_its_hips_height, Level) {
  gains.reach_joint_margin = 0.0;
  gains.reach_foot_depth = 0.15;
  motion.set_target({0.0, 0.0, -0.25, 0.0, 0.0, 0.0});
  run(4.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kFootHeight));
  BOOST_TEST(motion.status().motor % 3 == 0);
  const double least = legs.depth().minCoeff();
  BOOST_TEST(least >= gains.reach_foot_depth - 1e-9);
  BOOST_TEST(least < gains.reach_foot_depth + 2e-3);
  Dynamics dynamics(robot);
  dynamics.update(legs.q(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
  for (int leg = 0; leg < kLegs; ++leg) {
    BOOST_TEST(std::abs(legs.depth()[leg] - dynamics.legs()[leg].depth) < 1e-9);
  }
}

BOOST_FIXTURE_TEST_CASE(too_far_aside_stops_before_the_edge_of_the_support, Level) {
  gains.reach_joint_margin = 0.0;
  motion.set_target({0.0, 0.13, 0.0, 0.0, 0.0, 0.0});
  run(4.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kSupport));
  BOOST_TEST(support_room() >= gains.reach_support_margin - 1e-9);
  BOOST_TEST(support_room() < gains.reach_support_margin + 2e-3);
}

BOOST_FIXTURE_TEST_CASE(a_body_that_was_latched_beyond_a_margin_may_leave_it_and_go_no_further,
                        Level) {
  motion.set_target({0.0, 0.02, 0.0, 0.0, 0.0, 0.0});
  run(1.0);
  gains.reach_support_margin = 0.5;  // nobody has that much
  motion.set_target({0.0, 0.04, 0.0, 0.0, 0.0, 0.0});
  run(1.0);
  BOOST_TEST(motion.position().y < 0.021);
  BOOST_TEST((motion.status().limit == ReachLimit::kSupport));
  motion.set_target({0.0, 0.01, 0.0, 0.0, 0.0, 0.0});
  run(1.0);
  BOOST_TEST(std::abs(motion.position().y - 0.01) < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(feet_that_moved_take_the_centre_of_mass_along_without_a_jump_in_speed,
                        Level) {
  run(kDt);
  feet.col(FL_) += Vector3(0.02, 0.01, 0.0);
  run(0.1);
  const Vector3 before = motion.p_com();
  BOOST_TEST((before - center_of_mass(robot, state.q)).norm() > 1e-4);
  motion.set_target({0.0, 0.0, -0.002, 0.0, 0.0, 0.0});
  for (int k = 0; k < 50; ++k) {
    run(kDt);
    BOOST_REQUIRE(motion.v_com().norm() <= gains.reference_speed);
  }
}

BOOST_FIXTURE_TEST_CASE(a_target_beyond_all_bounds_is_a_target_far_away, Level) {
  for (const double far : {1e3, 1e200, 1.7e308}) {
    motion.set_target({far, 0.0, 0.0, 0.0, 0.0, 0.0});
    run(2.0);
    BOOST_TEST(motion.position().x > 0.02);
    BOOST_TEST((motion.status().limit != ReachLimit::kNone));
  }
}

BOOST_FIXTURE_TEST_CASE(a_request_that_is_no_number_says_so_until_the_next_one, Level) {
  motion.set_target({0.02, 0.0, 0.0, 0.0, 0.0, 0.0});
  run(0.02);
  motion.set_target({std::nan(""), 0.0, 0.0, 0.0, 0.0, 0.0});
  run(2.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kNotFinite));
  BOOST_TEST(std::abs(motion.position().x - 0.02) < 1e-4);
  motion.set_target({});
  BOOST_TEST((motion.status().limit == ReachLimit::kNone));
}

BOOST_FIXTURE_TEST_CASE(it_returns_from_a_limit_to_where_it_was_latched, Level) {
  motion.set_target({0.1, 0.1, -0.3, 0.5, 0.5, 0.5});
  run(4.0);
  BOOST_TEST((motion.status().limit != ReachLimit::kNone));
  motion.set_target({});
  run(4.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kNone));
  BOOST_TEST(vector_of(motion.position()).norm() < 1e-4);
  BOOST_TEST((motion.p_com() - center_of_mass(robot, state.q)).norm() < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(a_target_that_is_not_a_number_leaves_the_last_one_standing, Level) {
  motion.set_target({0.0, 0.0, -0.03, 0.0, 0.0, 0.0});
  run(0.1);
  motion.set_target({0.0, 0.0, std::nan(""), 0.0, 0.0, 0.0});
  BOOST_TEST((motion.status().limit == ReachLimit::kNotFinite));
  motion.set_target({0.0, 0.0, 0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0});
  BOOST_TEST((motion.status().limit == ReachLimit::kNotFinite));
  run(3.0);
  BOOST_TEST(std::abs(motion.position().height + 0.03) < 1e-4);
  BOOST_TEST(vector_of(motion.position()).allFinite());
}

BOOST_FIXTURE_TEST_CASE(velocities_are_those_of_the_pose_it_asks_for, Level) {
  motion.set_target({0.03, -0.02, -0.04, 0.2, -0.15, 0.3});
  run(0.1);
  const Quaternion R = motion.R_base();
  const Vector3 p_com = motion.p_com();
  run(kDt);
  const Vector3 turned = log_so3(motion.R_base() * R.conjugate()) / kDt;
  BOOST_TEST(turned.norm() > 0.3);
  BOOST_TEST((turned - motion.w_base()).norm() < 0.01 * turned.norm());
  // Its speed is that of the way to where it could stop.
  BOOST_TEST(((motion.p_com() - p_com) / kDt - motion.v_com()).norm() < 2e-3);
  BOOST_TEST(motion.v_com().norm() > 0.03);
}

BOOST_AUTO_TEST_SUITE_END()
