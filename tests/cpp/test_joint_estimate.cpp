// SPDX-License-Identifier: BSD-3-Clause
// Rotor inertia and friction of joints, learnt from synthetic swings.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "dynamics/dynamics.hpp"
#include "estimator/contact/joint_estimate.hpp"
#include "estimator/contact/leg_forces.hpp"
#include "quadruped.hpp"
#include "robot_states.hpp"
#include "wbc/input_check.hpp"

using namespace surefoot;

namespace {

constexpr double kPeriod = 0.002;

// Leg FL swings: its foot moves, its joints oscillate, and the joints differ from the model.
struct SwingFixture {
  Robot robot = quadruped();
  Dynamics dynamics{robot};
  JointEstimate joints{robot};
  RobotState state = standing_state(robot);
  double error = 0.0;       // [kg.m^2]
  double damping = 0.0;     // [N.m.s/rad]
  double coulomb = 0.0;     // [N.m]
  double foot_speed = 1.0;  // [m/s]
  double hit = 0.0;         // [N.m] torque that the model cannot explain
  double time = 0.0;        // [s]
  Vector12 stops = Vector12::Zero();
  Vector12 torque = Vector12::Zero();

  double configured() const { return robot.config().armature[0]; }
  // The dynamics keep the standing pose, so that M is constant.
  void swing(double seconds) {
    FeetMatrix v = FeetMatrix::Zero();
    v(0, FL_) = foot_speed;
    const double end = time + seconds;
    for (; time < end; time += kPeriod) {
      constexpr double w = 20.0, amplitude = 0.25;  // [rad/s], [rad]
      const double dq = amplitude * w * std::sin(w * time);
      Vector12 q = Vector12::Zero(), unfiltered = Vector12::Zero();
      q.segment<3>(3 * FL_).setConstant(-amplitude * std::cos(w * time));
      const double ddq = amplitude * w * w * std::cos(w * time);
      dynamics.set_joints(state);
      dynamics.update(state.q, state.v, Vector3::UnitZ());
      Vector3 tau = dynamics.legs()[FL_].M_leg * Vector3::Constant(ddq);
      tau += (Vector3::Constant(error) - state.armature_error.segment<3>(3 * FL_)) * ddq;
      tau += Vector3::Constant(damping * dq + (dq > 0.0 ? coulomb : -coulomb));
      unfiltered.segment<3>(3 * FL_) = tau + Vector3::Constant(hit);
      torque += kPeriod / (kPeriod + LegForces::kFilterTime) * (unfiltered - torque);
      joints.update({dynamics, v, torque, q, stops}, kPeriod);
      state.armature_error = joints.armature_error();
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(joint_estimate)

BOOST_FIXTURE_TEST_CASE(a_second_of_swing_teaches_the_armature_of_all_legs, SwingFixture) {
  for (const double share : {-0.5, 0.5, 1.0}) {
    joints.reset();
    state.armature_error.setZero();
    error = share * configured();
    swing(1.0);
    BOOST_TEST((state.armature_error.array() - error).abs().maxCoeff() < 0.15 * configured());
  }
}

BOOST_FIXTURE_TEST_CASE(friction_is_not_taken_for_armature, SwingFixture) {
  damping = 0.1;
  coulomb = 0.5;
  swing(2.0);
  BOOST_TEST(state.armature_error.cwiseAbs().maxCoeff() < 0.2 * configured());
  const double speed = 4.0, truth = coulomb + damping * speed;  // [rad/s], [N.m]
  const Vector12 learnt = joints.friction() + speed * joints.damping();
  BOOST_TEST((learnt.array() / truth - 1.0).abs().maxCoeff() < 0.2);
}

BOOST_FIXTURE_TEST_CASE(foot_that_does_not_move_teaches_nothing, SwingFixture) {
  error = configured();
  foot_speed = 0.1;
  swing(1.0);
  BOOST_TEST(state.armature_error.isZero());
}

BOOST_FIXTURE_TEST_CASE(joint_at_its_stop_teaches_nothing, SwingFixture) {
  error = configured();
  stops.setOnes();
  swing(1.0);
  BOOST_TEST(state.armature_error.isZero());
}

BOOST_FIXTURE_TEST_CASE(friction_that_falls_is_learnt_again, SwingFixture) {
  coulomb = 1.0;
  swing(3.0);
  BOOST_TEST(joints.friction().minCoeff() > 0.7);
  coulomb = 0.0;
  swing(40.0);
  BOOST_TEST(joints.friction().maxCoeff() < 0.2);
}

// Without pause(), the jump of the angles would be an acceleration of thousands of rad/s^2.
BOOST_FIXTURE_TEST_CASE(a_pause_in_a_swing_changes_nothing, SwingFixture) {
  swing(1.0);
  const Vector12 before = state.armature_error;
  joints.pause();
  time += 0.08;
  torque.setZero();
  swing(0.1);
  BOOST_TEST((state.armature_error - before).cwiseAbs().maxCoeff() < 0.1 * configured());
}

BOOST_FIXTURE_TEST_CASE(results_have_physical_limits, SwingFixture) {
  error = -3.0 * configured();
  damping = -1.0;
  swing(2.0);
  BOOST_TEST(state.armature_error.minCoeff() == -configured());
  BOOST_TEST(joints.damping().isZero());
  error = 0.0;
  damping = 100.0;
  swing(5.0);
  const RobotConfig& config = robot.config();
  BOOST_TEST((joints.damping().array() * config.no_load_speed.array() <=
              config.tau_max.array() * (1.0 + 1e-12))
                 .all());
}

BOOST_FIXTURE_TEST_CASE(a_foot_that_hits_something_changes_little, SwingFixture) {
  swing(1.0);
  hit = 10.0;
  swing(0.02);
  BOOST_TEST(state.armature_error.cwiseAbs().maxCoeff() < 0.2 * configured());
}

BOOST_AUTO_TEST_CASE(negative_friction_and_armature_are_implausible) {
  const Robot robot = quadruped();
  const RobotState valid = standing_state(robot);
  for (Vector12 RobotState::* field :
       {&RobotState::armature_error, &RobotState::joint_damping, &RobotState::joint_friction}) {
    RobotState state = valid;
    (state.*field)[5] = -1.0;
    BOOST_TEST((check_state(state, robot) == Status::kImplausible));
    (state.*field)[5] = NAN;
    BOOST_TEST((check_state(state, robot) == Status::kNonFinite));
  }
  BOOST_TEST((check_state(valid, robot) == Status::kOk));
}

// Learnt armature and friction are parts of M and h, in both sources of the dynamics.
BOOST_AUTO_TEST_CASE(joint_errors_are_added_to_the_equations_of_motion) {
  const Robot robot = quadruped();
  const RobotState state = random_state(robot, 3, 0.5);
  RobotState learnt = state;
  learnt.armature_error = Vector12::LinSpaced(0.001, 0.012);
  learnt.joint_damping = Vector12::LinSpaced(0.1, 1.2);
  for (const auto source : {Dynamics::Source::kAuto, Dynamics::Source::kPinocchio}) {
    Dynamics plain(robot, source), changed(robot, source);
    changed.set_joints(learnt);
    plain.update(state.q, state.v, Vector3::UnitZ());
    changed.update(state.q, state.v, Vector3::UnitZ());
    FullDynamics before(robot.nv()), after(robot.nv());
    plain.write_full(before);
    changed.write_full(after);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(robot.nv()), torque = expected;
    for (int i = 0; i < kMotors; ++i) expected[robot.motor_to_v()[i]] = learnt.armature_error[i];
    for (int i = 0; i < kMotors; ++i) {
      const int v = robot.motor_to_v()[i];
      torque[v] = learnt.joint_damping[i] * state.v[v];
    }
    BOOST_TEST((after.h - before.h).isApprox(torque, 1e-9));
    BOOST_TEST((after.M - before.M).isApprox(Eigen::MatrixXd(expected.asDiagonal()), 1e-9));
    BOOST_TEST((changed.legs()[RL_].M_leg - plain.legs()[RL_].M_leg)
                   .isApprox(Matrix3(learnt.armature_error.tail<3>().asDiagonal()), 1e-9));
  }
}

BOOST_AUTO_TEST_SUITE_END()
