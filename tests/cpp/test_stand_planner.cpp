// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "capture_point_robot.hpp"
#include "reference/planner_input.hpp"
#include "reference/stand_planner.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

struct StandPlannerFixture {
  Robot robot = quadruped();
  Gains gains;
  Dynamics dynamics{robot};
  RobotState state = random_state(robot, 2, 0.0);
  StandPlanner planner{robot};
  Reference reference;
  StandPlannerFixture() {
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    for (int tick = 0; tick < 3; ++tick) plan(dynamics, Eigen::Vector4d::Ones());  // latch the pose
  }
  const Reference& plan(const Dynamics& d, const Eigen::Vector4d& contact, double dt = 0.002) {
    state.contact = contact;
    planner.plan(make_planner_input(state, gains, d, dt, 0.0, robot.mass(), -1), reference);
    return reference;
  }
  // Move robot and ground together in the world, as a drift of the estimate does.
  Dynamics drifted(const Vector3& p, const Quaternion& R) const {
    Eigen::VectorXd q = state.q;
    q.head<3>() = p + R * Vector3(q.head<3>());
    q.segment<4>(3) = (R * Quaternion(q[6], q[3], q[4], q[5])).coeffs();
    Dynamics d(robot);
    d.update(q, state.v, Vector3::UnitZ());
    return d;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(stand_planner)

BOOST_AUTO_TEST_CASE(so3_exponential_and_logarithm_are_inverse) {
  for (int seed = 0; seed < 50; ++seed) {
    std::srand(static_cast<unsigned>(seed));
    const Vector3 w = 1.7 * Vector3::Random();
    BOOST_TEST((log_so3(exp_so3(w)) - w).norm() < 1e-12);
    Quaternion q = exp_so3(w);
    q.coeffs() *= -1.0;  // the same rotation
    BOOST_TEST((log_so3(q) - w).norm() < 1e-12);
  }
  BOOST_TEST(log_so3(exp_so3(Vector3(1e-12, 0, 0))).x() == 1e-12);
}

BOOST_FIXTURE_TEST_CASE(reference_equals_the_state_at_the_latched_pose, StandPlannerFixture) {
  const Reference& desired = plan(dynamics, Eigen::Vector4d::Ones());
  BOOST_TEST((desired.p_com - dynamics.p_world_com()).norm() < 1e-9);
  BOOST_TEST(desired.R_world_base.angularDistance(Quaternion(dynamics.R_world_base())) < 1e-6);
  BOOST_TEST(desired.a_com.norm() < 1e-9);
}

BOOST_FIXTURE_TEST_CASE(reference_follows_drift_of_position_and_yaw, StandPlannerFixture) {
  const Quaternion yaw(Eigen::AngleAxisd(1.3, Vector3::UnitZ()));
  const Dynamics moved = drifted(Vector3(3.0, -2.0, 0.5), yaw);
  // The ground normal follows slowly, so wait.
  for (int tick = 0; tick < 5000; ++tick) {
    plan(moved, Eigen::Vector4d::Ones());
  }
  const Reference& desired = reference;
  BOOST_TEST((desired.p_com - moved.p_world_com()).norm() < 1e-6);
  BOOST_TEST(desired.R_world_base.angularDistance(Quaternion(moved.R_world_base())) < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(reference_follows_an_imu_attitude_error_within_5_s, StandPlannerFixture) {
  const Dynamics moved =
      drifted(Vector3::Zero(), Quaternion(Eigen::AngleAxisd(0.02, Vector3::UnitX())));
  for (int tick = 0; tick < 2500; ++tick) {
    plan(moved, Eigen::Vector4d::Ones());
  }
  const Reference& desired = reference;
  BOOST_TEST(desired.R_world_base.angularDistance(Quaternion(moved.R_world_base())) < 2e-3);
}

BOOST_FIXTURE_TEST_CASE(lifted_foot_does_not_tilt_the_ground_normal, StandPlannerFixture) {
  const Vector3 before = plan(dynamics, Eigen::Vector4d::Ones(), 0.3).ground_normal;
  Eigen::VectorXd q = state.q;
  q[robot.motor_to_q()[FR_2]] -= 0.4;
  Dynamics lifted(robot);
  lifted.update(q, state.v, Vector3::UnitZ());
  for (int tick = 0; tick < 500; ++tick) {
    plan(lifted, Eigen::Vector4d(0, 1, 1, 1));
  }
  // A foot without contact has a weight of 1e-6.
  BOOST_TEST((reference.ground_normal - before).norm() < 1e-6);
}

BOOST_FIXTURE_TEST_CASE(feet_of_a_lifted_robot_follow_the_body_and_extend_downward,
                        StandPlannerFixture) {
  const double before = plan(dynamics, Eigen::Vector4d::Ones()).feet[FR_].p_world.z();
  // Robot and feet are 0.1 m higher and have no contact.
  const Dynamics lifted = drifted(Vector3(0, 0, 0.1), Quaternion::Identity());
  double height = 0.0;
  for (int tick = 0; tick < 1000; ++tick) {
    height = plan(lifted, Eigen::Vector4d::Zero()).feet[FR_].p_world.z();
  }
  const double stood = dynamics.p_world_base().z() - before;
  const double hangs = lifted.p_world_base().z() - height;
  BOOST_TEST(hangs > 1.05 * stood);
  BOOST_TEST(hangs < 1.25 * stood);
  // Back on the ground the feet are stance feet at once, at their present positions.
  const double there = plan(lifted, Eigen::Vector4d::Ones()).feet[FR_].p_world.z();
  BOOST_TEST(std::abs(there - lifted.legs()[FR_].p_world_contact.z()) < 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
