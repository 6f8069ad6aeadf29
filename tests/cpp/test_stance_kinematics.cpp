// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "dynamics/stance_kinematics.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

struct StanceKinematicsFixture {
  Robot robot = quadruped();
  RobotState state = standing_state(robot);
  FeetMatrix feet = contact_points(robot, state.q);
  StanceKinematics legs{robot};
  bool solve(const Vector3& by, const Quaternion& turn = Quaternion::Identity()) {
    return legs.solve(state.q.head<3>() + by, turn, feet, Vector3::UnitZ());
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(stance_kinematics)

BOOST_FIXTURE_TEST_CASE(joint_angles_reach_the_desired_contact_points, StanceKinematicsFixture) {
  for (int k = 0; k < 1000; ++k) {
    const Vector3 phase(0.011 * k, 0.017 * k, 0.007 * k);
    const Vector3 by = 0.04 * phase.array().sin(), turn = 0.15 * (2.0 * phase).array().sin();
    BOOST_REQUIRE(solve(by, exp_so3(turn)));
    BOOST_TEST((contact_points(robot, legs.q()) - feet).colwise().norm().maxCoeff() < 2e-6);
    BOOST_TEST((legs.q().head<3>() - state.q.head<3>() - by).norm() < 1e-15);
    BOOST_TEST((Quaternion(legs.q()[6], legs.q()[3], legs.q()[4], legs.q()[5])
                    .angularDistance(exp_so3(turn))) < 1e-7);
    BOOST_TEST((legs.p_com() - center_of_mass(robot, legs.q())).norm() < 1e-12);
  }
}

BOOST_FIXTURE_TEST_CASE(tilted_ground_normal_moves_the_contact_on_the_foot_sphere,
                        StanceKinematicsFixture) {
  const Vector3 normal = Vector3(0.2, -0.1, 1.0).normalized();
  BOOST_REQUIRE(legs.solve(state.q.head<3>(), Quaternion::Identity(), feet, normal));
  const FeetMatrix centres =
      contact_points(robot, legs.q()).colwise() + robot.config().foot_radius * Vector3::UnitZ();
  const FeetMatrix touching = centres.colwise() - robot.config().foot_radius * normal;
  BOOST_TEST((touching - feet).colwise().norm().maxCoeff() < 2e-6);
}

BOOST_FIXTURE_TEST_CASE(unreachable_pose_is_refused_and_the_last_solution_is_kept,
                        StanceKinematicsFixture) {
  BOOST_REQUIRE(solve(Vector3(0.01, 0.0, 0.0)));
  const Eigen::VectorXd q = legs.q();
  const Vector3 p_com = legs.p_com();
  for (const double height : {0.2, 0.5, 5.0, 1e6, std::nan("")}) {
    BOOST_TEST(!solve(Vector3(0.0, 0.0, height)));
    BOOST_TEST((legs.q() - q).norm() == 0.0);
    BOOST_TEST((legs.p_com() - p_com).norm() == 0.0);
  }
  BOOST_TEST(solve(Vector3::Zero()));
}

BOOST_FIXTURE_TEST_CASE(knees_keep_their_bending_direction, StanceKinematicsFixture) {
  for (int k = 0; k < 400; ++k) {
    solve(Vector3(0.0, 0.0, 0.06 * std::sin(0.05 * k) - 0.05));
    for (int leg = 0; leg < kLegs; ++leg) {
      BOOST_REQUIRE(legs.q()[robot.motor_to_q()[3 * leg + 2]] < 0.0);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(solution_starts_from_the_given_joint_angles, StanceKinematicsFixture) {
  Eigen::VectorXd mirrored = state.q;  // knees bent the other way: also a solution
  for (int leg = 0; leg < kLegs; ++leg) {
    mirrored[robot.motor_to_q()[3 * leg + 1]] *= -1.0;
    mirrored[robot.motor_to_q()[3 * leg + 2]] *= -1.0;
  }
  legs.set_initial_guess(mirrored);
  BOOST_REQUIRE(solve(Vector3(0.0, 0.0, -0.01)));
  BOOST_TEST(legs.q()[robot.motor_to_q()[FL_2]] > 1.0);
}

BOOST_AUTO_TEST_SUITE_END()
