// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include "estimator/filter/foot_motion_model.hpp"
#include "reference/planner_input.hpp"
#include "reference/stand_planner.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

constexpr double kDt = 0.002;

// Velocities of a body that moves with a twist over feet that roll without slip.
Eigen::VectorXd rolling_velocities(const Robot& robot, const Dynamics& dynamics,
                                   const Vector6& twist, long nv) {
  Eigen::VectorXd v = Eigen::VectorXd::Zero(nv);
  v.head<6>() = twist;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = dynamics.legs()[leg];
    const Vector3 joints = -L.J_leg.inverse() * (L.J_base * twist);
    for (int k = 0; k < 3; ++k) v[robot.motor_to_v()[3 * leg + k]] = joints[k];
  }
  return v;
}

struct RollingFeetFixture {
  Robot robot = quadruped();
  Dynamics dynamics{robot};
  RobotState state = standing_state(robot);
  RollingFeetFixture() {
    const Quaternion R = exp_so3(1.3 * Vector3::UnitZ()) * exp_so3(0.1 * Vector3::UnitY());
    state.q.segment<4>(3) = R.coeffs();
    dynamics.update(state.q, state.v, Vector3::UnitZ());
  }

  void step(const Vector6& twist) {
    state.v = rolling_velocities(robot, dynamics, twist, state.v.size());
    state.q = integrate(robot, state.q, kDt * state.v);
    dynamics.update(state.q, state.v, Vector3::UnitZ());
  }
};

// Base axes: mostly forward, a little sideways, pitching and yawing.
Vector6 forward_twist() {
  Vector6 twist;
  twist << 0.4, 0.1, 0.0, 0.05, 0.3, 0.2;
  return twist;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(foot_rolling)

BOOST_FIXTURE_TEST_CASE(rolling_displacement_matches_contact_points_without_slip,
                        RollingFeetFixture) {
  FootRolling rolling(robot.config().foot_radius);
  const FeetMatrix before = contact_points(robot, state.q);
  for (int tick = 0; tick < 50; ++tick) {
    step(forward_twist());
    rolling.update(dynamics, Vector3::UnitZ(), Eigen::Vector4d(1, 0.5, 0, 1), kDt);
  }
  const FeetMatrix displacement = contact_points(robot, state.q) - before;
  BOOST_TEST(displacement.col(FR_).norm() > 0.001);
  // FootRolling forgets about a twentieth of the displacement within these 0.1 s.
  BOOST_TEST((rolling.displacement().col(FR_) - displacement.col(FR_)).norm() <
             0.06 * displacement.col(FR_).norm());
  BOOST_TEST((rolling.displacement().col(FL_) - 0.5 * displacement.col(FL_)).norm() <
             0.06 * displacement.col(FL_).norm());
  BOOST_TEST(rolling.displacement().col(RR_).norm() == 0.0);
  rolling.reset();
  BOOST_TEST(rolling.displacement().norm() == 0.0);
}

BOOST_FIXTURE_TEST_CASE(filter_contact_points_follow_joint_angles_across_a_sample_gap,
                        RollingFeetFixture) {
  FootMotionModel foot_motion;
  const FeetMatrix lever = (robot.config().foot_radius * Vector3::UnitZ()).replicate<1, kLegs>();
  const auto roll = [&](double dt) {
    Vector12 q;
    for (int i = 0; i < kMotors; ++i) q[i] = state.q[robot.motor_to_q()[i]];
    return foot_motion.rolling_displacement(dynamics, q, Eigen::Vector4d(1, 0.5, 0, 1), lever, dt);
  };
  for (int round = 0; round < 2; ++round) {
    BOOST_TEST(roll(kDt).norm() == 0.0);
    const FeetMatrix before = contact_points(robot, state.q);
    FeetMatrix sum = FeetMatrix::Zero();
    for (int tick = 0; tick < 50; ++tick) {
      step(forward_twist());
      if (tick == 20) continue;  // a lost sample
      sum += roll(tick == 21 ? 2.0 * kDt : kDt);
    }
    const FeetMatrix displacement = contact_points(robot, state.q) - before;
    BOOST_TEST(displacement.col(FR_).norm() > 0.001);
    BOOST_TEST((sum.col(FR_) - displacement.col(FR_)).norm() < 0.02 * displacement.col(FR_).norm());
    BOOST_TEST((sum.col(FL_) - 0.5 * displacement.col(FL_)).norm() <
               0.02 * displacement.col(FL_).norm());
    BOOST_TEST(sum.col(RR_).norm() == 0.0);
    foot_motion.reset();
  }
}

BOOST_FIXTURE_TEST_CASE(stuck_gyroscope_causes_bounded_rolling_that_decays, RollingFeetFixture) {
  const double radius = robot.config().foot_radius;
  FootRolling rolling(radius);
  state.v[4] = 2.0;
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  for (int tick = 0; tick < 1000; ++tick) {
    rolling.update(dynamics, Vector3::UnitZ(), Eigen::Vector4d::Ones(), kDt);
    BOOST_TEST_REQUIRE(rolling.displacement().colwise().norm().maxCoeff() < 0.41 * radius);
  }
  BOOST_TEST(rolling.displacement().colwise().norm().minCoeff() > 0.39 * radius);
  state.v.setZero();
  dynamics.update(state.q, state.v, Vector3::UnitZ());
  for (int tick = 0; tick < 5000; ++tick) {
    rolling.update(dynamics, Vector3::UnitZ(), Eigen::Vector4d::Ones(), kDt);
  }
  BOOST_TEST(rolling.displacement().norm() < 0.01 * radius);
}

BOOST_FIXTURE_TEST_CASE(lifted_foot_does_not_move_with_rolling_stance_feet, RollingFeetFixture) {
  const Gains gains = robot.config().gains;
  StandPlanner planner(robot);
  Reference desired;
  const auto plan = [&] {
    planner.plan(make_planner_input(state, gains, dynamics, kDt, 0.0, robot.mass(), -1), desired);
  };
  for (int tick = 0; tick < 3; ++tick) plan();  // latch the pose
  const FeetMatrix before = contact_points(robot, state.q);
  state.contact = Eigen::Vector4d(0, 1, 1, 1);
  for (int tick = 0; tick < 75; ++tick) {
    step(forward_twist());
    plan();
  }
  const FeetMatrix displacement = contact_points(robot, state.q) - before;
  const auto moved = [&](int leg) { return (desired.feet[leg].p_world - before.col(leg)).norm(); };
  BOOST_TEST(displacement.col(FL_).norm() > 0.002);
  BOOST_TEST(moved(FR_) < 0.15 * displacement.col(FL_).norm());
  for (int leg : {FL_, RR_, RL_}) {
    const Vector3 off = desired.feet[leg].p_world - before.col(leg) - displacement.col(leg);
    BOOST_TEST(off.norm() < 0.15 * displacement.col(leg).norm());
  }
}

BOOST_AUTO_TEST_SUITE_END()
