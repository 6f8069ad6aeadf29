// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dynamics/dynamics.hpp"
#include "reference/body_motion.hpp"
#include "reference/support_polygon.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

Vector6 vector_of(const BodyReference& r) {
  Vector6 v;
  v << r.x, r.y, r.height, r.roll, r.pitch, r.yaw;
  return v;
}

// A level standing robot: the origin of its support frame is below its base.
struct BodyMotionFixture {
  Robot robot;
  Gains gains;
  RobotState state = standing_state(robot);
  FeetMatrix feet = contact_points(robot, state.q);
  BodyMotion motion{robot};
  StanceKinematics legs{robot};
  double max_speed = 0.0, max_turn_speed = 0.0, max_acceleration = 0.0;  // largest so far
  Vector6 last_speed = Vector6::Zero();
  BodyMotionFixture() : BodyMotionFixture(quadruped()) {}
  explicit BodyMotionFixture(const Robot& of) : robot(of) {
    legs.set_initial_guess(state.q);
    motion.latch({state.q.head<3>(), Quaternion::Identity()}, center_of_mass(robot, state.q),
                 state.q);
  }
  void run(double seconds) {
    for (int k = 0; k < seconds / kDt; ++k) {
      const Vector6 before = vector_of(motion.relative_pose());
      motion.update(gains, feet, -Vector3::UnitZ(), kDt);
      BOOST_REQUIRE(legs.solve(motion.p_base(), motion.R_base(), feet, Vector3::UnitZ()));
      const Vector6 speed = (vector_of(motion.relative_pose()) - before) / kDt;
      max_acceleration = std::max(max_acceleration, (speed - last_speed).head<3>().norm() / kDt);
      last_speed = speed;
      max_speed = std::max(max_speed, speed.head<3>().norm());
      max_turn_speed = std::max(max_turn_speed, speed.tail<3>().norm());
    }
  }
  // Smallest distance of a joint from its limits in the desired pose [rad].
  double joint_margin() const {
    double room = 1e9;
    for (int i = 0; i < kMotors; ++i) {
      const double q = legs.q()[robot.motor_to_q()[i]];
      room = std::min({room, q - robot.config().q_lower[i], robot.config().q_upper[i] - q});
    }
    return room;
  }
  // Angle by which a hip turns its leg inward under the trunk, in the desired pose [rad].
  double hip_inward(int motor) const {
    const double q = legs.q()[robot.motor_to_q()[motor]];
    return motor / 3 % 2 == 1 ? -q : q;
  }
  double support_margin() const {
    return SupportPolygon(feet, {true, true, true, true}).margin(motion.p_com().head<2>());
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(body_motion)

BOOST_FIXTURE_TEST_CASE(reachable_target_is_reached_within_speed_and_acceleration_gains,
                        BodyMotionFixture) {
  const BodyReference target{0.03, -0.02, -0.04, 0.1, -0.08, 0.15};
  motion.set_target(target);
  run(3.0);
  BOOST_TEST((vector_of(motion.relative_pose()) - vector_of(target)).norm() < 1e-4);
  BOOST_TEST((motion.status().limit == ReachLimit::kNone));
  BOOST_TEST(max_speed <= gains.reference_speed + 1e-9);
  BOOST_TEST(max_speed > 0.6 * gains.reference_speed);
  BOOST_TEST(max_acceleration <= gains.reference_acceleration * (1.0 + 1e-6));
  BOOST_TEST(max_turn_speed <= gains.reference_turn_speed + 1e-9);
  BOOST_TEST(max_turn_speed > 0.9 * gains.reference_turn_speed);
  BOOST_TEST(motion.v_com().norm() == 0.0);
  BOOST_TEST(motion.w_base().norm() == 0.0);
}

// Sixty random requests in 60 s, most of them beyond the joint limits or the support.
BOOST_FIXTURE_TEST_CASE(random_targets_keep_speed_joint_and_support_limits_for_60_s,
                        BodyMotionFixture) {
  std::srand(11);
  double joint = 1e9, support = 1e9;
  for (int request = 0; request < 60; ++request) {
    const Vector6 r = Vector6::Random();
    motion.set_target({0.15 * r[0], 0.15 * r[1], 0.12 * r[2], 0.5 * r[3], 0.5 * r[4], r[5]});
    for (int k = 0; k < 500; ++k) {
      run(kDt);
      joint = std::min(joint, joint_margin());
      support = std::min(support, support_margin());
    }
  }
  BOOST_TEST(max_speed <= gains.reference_speed + 1e-9);
  BOOST_TEST(max_speed > 0.6 * gains.reference_speed);
  BOOST_TEST(max_acceleration <= gains.reference_acceleration * (1.0 + 1e-6));
  BOOST_TEST(max_turn_speed <= gains.reference_turn_speed + 1e-9);
  BOOST_TEST(max_turn_speed > 0.9 * gains.reference_turn_speed);
  // With several axes moving, the path to a stop is a curve. BodyMotion checks only its end.
  BOOST_TEST(joint >= gains.reach_joint_margin - 2e-3);
  BOOST_TEST(joint < gains.reach_joint_margin + 0.01);
  BOOST_TEST(support >= gains.reach_support_margin - 1e-3);
  BOOST_TEST(support < gains.reach_support_margin + 0.01);
}

BOOST_FIXTURE_TEST_CASE(low_target_stops_at_a_knee_limit_and_reports_the_motor, BodyMotionFixture) {
  motion.set_target({0.0, 0.0, -0.25, 0.0, 0.0, 0.0});
  run(4.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kJoint));
  BOOST_TEST(motion.status().motor % 3 != 0);
  BOOST_TEST(motion.relative_pose().height < -0.05);
  BOOST_TEST(motion.relative_pose().height > -0.25);
  BOOST_TEST(joint_margin() >= gains.reach_joint_margin - 1e-9);
  BOOST_TEST(joint_margin() < gains.reach_joint_margin + 2e-3);
  BOOST_TEST(motion.v_com().norm() == 0.0);
}

BOOST_AUTO_TEST_CASE(roll_target_stops_at_the_inward_hip_limit) {
  RobotConfig config = quadruped_config();
  config.hip_inward = 0.3;
  BodyMotionFixture level(quadruped(config));
  level.motion.set_target({0.0, 0.0, 0.0, 0.45, 0.0, 0.0});
  level.run(4.0);
  const ReachStatus status = level.motion.status();
  BOOST_TEST((status.limit == ReachLimit::kJoint));
  BOOST_TEST(status.motor % 3 == 0);
  const double inward = level.gains.reach_joint_margin + level.hip_inward(status.motor);
  BOOST_TEST(inward <= 0.3 + 1e-9);
  BOOST_TEST(inward > 0.3 - 2e-3);
}

BOOST_FIXTURE_TEST_CASE(low_target_stops_at_the_minimum_foot_depth_below_the_hip,
                        BodyMotionFixture) {
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

BOOST_FIXTURE_TEST_CASE(lateral_target_stops_before_the_support_polygon_edge, BodyMotionFixture) {
  gains.reach_joint_margin = 0.0;
  motion.set_target({0.0, 0.13, 0.0, 0.0, 0.0, 0.0});
  run(4.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kSupport));
  BOOST_TEST(support_margin() >= gains.reach_support_margin - 1e-9);
  BOOST_TEST(support_margin() < gains.reach_support_margin + 2e-3);
}

BOOST_FIXTURE_TEST_CASE(body_latched_outside_a_margin_moves_only_back_inside, BodyMotionFixture) {
  motion.set_target({0.0, 0.02, 0.0, 0.0, 0.0, 0.0});
  run(1.0);
  gains.reach_support_margin = 0.5;  // no robot has this margin
  motion.set_target({0.0, 0.04, 0.0, 0.0, 0.0, 0.0});
  run(1.0);
  BOOST_TEST(motion.relative_pose().y < 0.021);
  BOOST_TEST((motion.status().limit == ReachLimit::kSupport));
  motion.set_target({0.0, 0.01, 0.0, 0.0, 0.0, 0.0});
  run(1.0);
  BOOST_TEST(std::abs(motion.relative_pose().y - 0.01) < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(moved_foot_shifts_the_com_reference_without_a_velocity_step,
                        BodyMotionFixture) {
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

BOOST_FIXTURE_TEST_CASE(huge_finite_target_stops_at_a_reach_limit, BodyMotionFixture) {
  for (const double far : {1e3, 1e200, 1.7e308}) {
    motion.set_target({far, 0.0, 0.0, 0.0, 0.0, 0.0});
    run(2.0);
    BOOST_TEST(motion.relative_pose().x > 0.02);
    BOOST_TEST((motion.status().limit != ReachLimit::kNone));
  }
}

BOOST_FIXTURE_TEST_CASE(nan_target_reports_not_finite_until_the_next_target, BodyMotionFixture) {
  motion.set_target({0.02, 0.0, 0.0, 0.0, 0.0, 0.0});
  run(0.02);
  motion.set_target({std::nan(""), 0.0, 0.0, 0.0, 0.0, 0.0});
  run(2.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kNotFinite));
  BOOST_TEST(std::abs(motion.relative_pose().x - 0.02) < 1e-4);
  motion.set_target({});
  BOOST_TEST((motion.status().limit == ReachLimit::kNone));
}

BOOST_FIXTURE_TEST_CASE(zero_target_returns_from_a_limit_to_the_latched_pose, BodyMotionFixture) {
  motion.set_target({0.1, 0.1, -0.3, 0.5, 0.5, 0.5});
  run(4.0);
  BOOST_TEST((motion.status().limit != ReachLimit::kNone));
  motion.set_target({});
  run(4.0);
  BOOST_TEST((motion.status().limit == ReachLimit::kNone));
  BOOST_TEST(vector_of(motion.relative_pose()).norm() < 1e-4);
  BOOST_TEST((motion.p_com() - center_of_mass(robot, state.q)).norm() < 1e-4);
}

BOOST_FIXTURE_TEST_CASE(nan_target_keeps_the_previous_target, BodyMotionFixture) {
  motion.set_target({0.0, 0.0, -0.03, 0.0, 0.0, 0.0});
  run(0.1);
  motion.set_target({0.0, 0.0, std::nan(""), 0.0, 0.0, 0.0});
  BOOST_TEST((motion.status().limit == ReachLimit::kNotFinite));
  motion.set_target({0.0, 0.0, 0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0});
  BOOST_TEST((motion.status().limit == ReachLimit::kNotFinite));
  run(3.0);
  BOOST_TEST(std::abs(motion.relative_pose().height + 0.03) < 1e-4);
  BOOST_TEST(vector_of(motion.relative_pose()).allFinite());
}

BOOST_FIXTURE_TEST_CASE(reference_velocities_match_the_derivative_of_the_pose, BodyMotionFixture) {
  motion.set_target({0.03, -0.02, -0.04, 0.2, -0.15, 0.3});
  run(0.1);
  const Quaternion R = motion.R_base();
  const Vector3 p_com = motion.p_com();
  run(kDt);
  const Vector3 turned = log_so3(motion.R_base() * R.conjugate()) / kDt;
  BOOST_TEST(turned.norm() > 0.3);
  BOOST_TEST((turned - motion.w_base()).norm() < 0.01 * turned.norm());
  // v_com() is the mean velocity on the path to the stop, so it differs a little.
  BOOST_TEST(((motion.p_com() - p_com) / kDt - motion.v_com()).norm() < 2e-3);
  BOOST_TEST(motion.v_com().norm() > 0.03);
}

BOOST_AUTO_TEST_SUITE_END()
