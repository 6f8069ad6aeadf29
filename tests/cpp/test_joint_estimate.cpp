// SPDX-License-Identifier: BSD-3-Clause
// Rotor inertia learnt from synthetic swings.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dynamics/dynamics.hpp"
#include "estimator/contact/joint_estimate.hpp"
#include "quadruped.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

// Leg FL swings: its foot moves, its joints oscillate, and the true armature is larger by `error`.
struct SwingFixture {
  Robot robot = quadruped();
  ArmatureEstimate armature{robot};
  double error = 0.0;     // [kg.m^2]
  double damping = 0.0;   // [N.m.s/rad]
  double coulomb = 0.0;   // [N.m]
  double foot_speed = 1;  // [m/s]
  double hit = 0.0;       // [N.m] torque that the model cannot explain

  const Vector12& swing(double seconds) {
    FeetMatrix v = FeetMatrix::Zero();
    v(0, FL_) = foot_speed;
    for (int k = 0; k < seconds / kPeriod; ++k) {
      constexpr double w = 20.0;  // [rad/s]
      const double phase = w * k * kPeriod, speed = 5.0 * std::sin(phase);
      Vector12 dq = Vector12::Zero(), ddq = Vector12::Zero(), missing = Vector12::Zero();
      dq.segment<3>(3 * FL_).setConstant(speed);
      ddq.segment<3>(3 * FL_).setConstant(5.0 * w * std::cos(phase));
      missing = (error * Vector12::Ones() - armature.error()).cwiseProduct(ddq) + damping * dq;
      missing.array() += coulomb * dq.array().sign();
      missing.segment<3>(3 * FL_).array() += hit;
      armature.update({v, missing, ddq, dq}, kPeriod);
    }
    return armature.error();
  }
  double configured() const { return robot.config().armature[0]; }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(joint_estimate)

BOOST_FIXTURE_TEST_CASE(half_a_second_of_swing_teaches_the_armature_of_all_legs, SwingFixture) {
  for (const double share : {-0.5, 0.5, 1.0}) {
    armature.reset();
    error = share * configured();
    for (const double learnt : swing(0.5))
      BOOST_TEST(std::abs(learnt - error) < 0.1 * configured());
  }
}

BOOST_FIXTURE_TEST_CASE(friction_of_the_joints_is_not_taken_for_armature, SwingFixture) {
  damping = 0.1;
  coulomb = 0.5;
  BOOST_TEST(swing(1.0).cwiseAbs().maxCoeff() < 0.1 * configured());
}

BOOST_FIXTURE_TEST_CASE(foot_that_does_not_move_teaches_nothing, SwingFixture) {
  error = configured();
  foot_speed = 0.1;
  BOOST_TEST(swing(1.0).isZero());
}

BOOST_FIXTURE_TEST_CASE(armature_is_never_negative, SwingFixture) {
  error = -3.0 * configured();
  BOOST_TEST(swing(2.0).minCoeff() == -configured());
}

BOOST_FIXTURE_TEST_CASE(a_foot_that_hits_something_changes_little, SwingFixture) {
  swing(0.5);
  hit = 10.0;
  swing(0.02);
  hit = 0.0;
  BOOST_TEST(swing(0.0).cwiseAbs().maxCoeff() < 0.2 * configured());
}

// The learnt armature is a part of the mass matrix, in both sources of the dynamics.
BOOST_AUTO_TEST_CASE(armature_error_is_added_to_the_mass_matrix) {
  const Robot robot = quadruped();
  const RobotState state = random_state(robot, 3, 0.5);
  const Vector12 error = Vector12::LinSpaced(0.001, 0.012);
  for (const auto source : {Dynamics::Source::kAuto, Dynamics::Source::kPinocchio}) {
    Dynamics plain(robot, source), changed(robot, source);
    changed.set_armature_error(error);
    plain.update(state.q, state.v, Vector3::UnitZ());
    changed.update(state.q, state.v, Vector3::UnitZ());
    FullDynamics before(robot.nv()), after(robot.nv());
    plain.write_full(before);
    changed.write_full(after);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(robot.nv());
    for (int i = 0; i < kMotors; ++i) expected[robot.motor_to_v()[i]] = error[i];
    BOOST_TEST((after.M - before.M).isApprox(Eigen::MatrixXd(expected.asDiagonal()), 1e-9));
    BOOST_TEST((changed.legs()[RL_].M_leg - plain.legs()[RL_].M_leg)
                   .isApprox(Matrix3(error.tail<3>().asDiagonal()), 1e-9));
  }
}

BOOST_AUTO_TEST_SUITE_END()
