// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "dynamics/dynamics.hpp"
#include "robot_states.hpp"

using namespace surefoot;

namespace {

constexpr double kStep = 1e-6;

struct DynamicsFixture {
  Robot robot = quadruped();
  RobotState state = random_state(robot, 3, 1.0);
  Vector3 normal = Vector3(0.1, -0.05, 1.0).normalized();
  Dynamics dynamics_now{robot};
  DynamicsFixture() { dynamics_now.update(state.q, state.v, normal); }

  // The same motion after `dt`, at constant joint and base velocity.
  Dynamics dynamics_after(double dt) const {
    Dynamics d(robot);
    d.update(integrate(robot, state.q, dt * state.v), state.v, normal);
    return d;
  }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(dynamics)

BOOST_FIXTURE_TEST_CASE(dynamics_blocks_match_pinocchio_mass_matrix_and_bias, DynamicsFixture) {
  const Eigen::MatrixXd M = mass_matrix(robot, state.q);
  const Eigen::VectorXd h = inverse_dynamics(robot, state, Eigen::VectorXd::Zero(robot.nv()));
  BOOST_TEST((dynamics_now.M_base() - M.topLeftCorner<6, 6>()).norm() < 1e-10);
  BOOST_TEST((dynamics_now.h_base() - h.head<6>()).norm() < 1e-10);
  for (int leg = 0; leg < kLegs; ++leg) {
    const int first = robot.motor_to_v()[3 * leg];
    const LegDynamics& L = dynamics_now.legs()[leg];
    BOOST_TEST((L.M_leg - M.block<3, 3>(first, first)).norm() < 1e-10);
    BOOST_TEST((L.M_base_leg - M.block<6, 3>(0, first)).norm() < 1e-10);
    BOOST_TEST((L.h_leg - h.segment<3>(first)).norm() < 1e-10);
  }
}

BOOST_FIXTURE_TEST_CASE(centre_of_mass_velocity_is_the_derivative_of_its_position,
                        DynamicsFixture) {
  const Vector3 difference =
      (dynamics_after(kStep).p_world_com() - dynamics_after(-kStep).p_world_com()) / (2.0 * kStep);
  BOOST_TEST((difference - dynamics_now.v_world_com()).norm() < 1e-7);
}

// The material point at the contact has the velocity of the foot centre minus w_calf x (radius n).
BOOST_FIXTURE_TEST_CASE(contact_velocity_is_foot_centre_velocity_minus_rolling, DynamicsFixture) {
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 centre_speed = (dynamics_after(kStep).legs()[leg].p_world_contact -
                                  dynamics_after(-kStep).legs()[leg].p_world_contact) /
                                 (2.0 * kStep);
    const Vector3 w_calf = dynamics_now.w_world_base() + dynamics_now.R_world_base() * [&] {
      // hip axis: x; thigh and calf axes: y, rotated by the hip
      const double hip = state.q[robot.motor_to_q()[3 * leg]];
      const int v = robot.motor_to_v()[3 * leg];
      const Vector3 pitch_axis(0.0, std::cos(hip), std::sin(hip));
      return Vector3(Vector3::UnitX() * state.v[v] +
                     pitch_axis * (state.v[v + 1] + state.v[v + 2]));
    }();
    const Vector3 lever = robot.config().foot_radius * normal;
    const Vector3 expected = centre_speed - w_calf.cross(lever);
    BOOST_TEST((dynamics_now.legs()[leg].v_world_contact - expected).norm() < 1e-7);
  }
}

// The drift is d/dt (J v) at constant v, where the base velocity is in base axes.
BOOST_FIXTURE_TEST_CASE(drift_is_the_contact_acceleration_at_zero_generalised_acceleration,
                        DynamicsFixture) {
  const Dynamics after = dynamics_after(kStep), before = dynamics_after(-kStep);
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 difference =
        (after.legs()[leg].v_world_contact - before.legs()[leg].v_world_contact) / (2.0 * kStep);
    BOOST_TEST((dynamics_now.legs()[leg].drift - difference).norm() < 1e-5);
  }
}

BOOST_FIXTURE_TEST_CASE(shift_of_a_resting_base_matches_the_moving_base, DynamicsFixture) {
  RobotState resting = state;
  resting.q.head<3>().setZero();
  resting.v.head<3>().setZero();
  Dynamics shifted(robot);
  shifted.update(resting.q, resting.v, normal);
  shifted.shift(state.q.head<3>(), dynamics_now.R_world_base() * Vector3(state.v.head<3>()));
  BOOST_TEST((shifted.p_world_com() - dynamics_now.p_world_com()).norm() < 1e-12);
  BOOST_TEST((shifted.v_world_com() - dynamics_now.v_world_com()).norm() < 1e-12);
  for (int leg = 0; leg < kLegs; ++leg) {
    BOOST_TEST(
        (shifted.legs()[leg].v_world_contact - dynamics_now.legs()[leg].v_world_contact).norm() <
        1e-12);
    BOOST_TEST(
        (shifted.legs()[leg].p_world_contact - dynamics_now.legs()[leg].p_world_contact).norm() <
        1e-12);
  }
}

BOOST_AUTO_TEST_SUITE_END()
