// SPDX-License-Identifier: BSD-3-Clause
#include <boost/test/unit_test.hpp>

#include "pushed_robot.hpp"
#include "surefoot/error.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "wbc/friction_cone.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(wbc)

BOOST_AUTO_TEST_CASE(friction_pyramid_covers_at_least_97_percent_of_the_cone) {
  const Vector3 normal = Vector3(0.2, -0.1, 1.0).normalized();
  const ConeRows rows = friction_cone(normal, 0.6);
  const Vector3 x = normal.cross(Vector3::UnitY()).normalized(), y = normal.cross(x);
  for (int k = 0; k < 360; ++k) {
    const double angle = k * M_PI / 180.0;
    const Vector3 tangent = std::cos(angle) * x + std::sin(angle) * y;
    const Vector3 inside = normal + 0.97 * 0.6 * tangent, outside = normal + 1.0001 * 0.6 * tangent;
    BOOST_TEST((rows * inside).maxCoeff() <= 0.0);
    BOOST_TEST((rows * outside).maxCoeff() > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(torques_stay_within_motor_limits_for_any_reference) {
  const Robot robot = quadruped();
  WholeBodyController controller(robot);
  for (int seed = 0; seed < 100; ++seed) {
    const RobotState state = random_state(robot, seed, 10.0);
    Reference reference = reference_at(robot, state);
    reference.a_com = 100.0 * Vector3(seed % 3 - 1, seed % 5 - 2, seed % 7 - 3);
    const Solution& solution = controller.update(state, reference);
    BOOST_TEST(is_usable(solution.status));
    for (int i = 0; i < kMotors; ++i) {
      const double tau = solution.torques[robot.motor_to_v()[i] - 6];
      const double dq = state.v[robot.motor_to_v()[i]];
      BOOST_TEST(std::abs(tau) <= motor_torque_limit(robot.config(), i, dq, tau) + 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(identical_inputs_give_identical_torques) {
  const Robot robot = quadruped();
  WholeBodyController a(robot), b(robot);
  for (int seed = 0; seed < 20; ++seed) {
    const RobotState state = random_state(robot, seed, 1.0);
    const Reference reference = reference_at(robot, state);
    BOOST_TEST((a.update(state, reference).torques == b.update(state, reference).torques));
  }
}

BOOST_AUTO_TEST_CASE(weight_smooth_reduces_force_changes_between_ticks) {
  const Robot robot = quadruped();
  Gains plain;
  plain.weight_force = 0.02;
  Gains smooth = plain;
  smooth.weight_smooth = 0.2;
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    WholeBodyController unsmoothed(robot, plain, {form, 1e-9}),
        smoothed(robot, smooth, {form, 1e-9});
    const RobotState state = standing_state(robot);
    Reference reference = reference_at(robot, state);
    reference.use_forces = true;
    const auto pull = [&](double lateral) {
      for (int leg = 0; leg < kLegs; ++leg) {
        reference.feet[leg].f_world = {0.0, leg % 2 ? -lateral : lateral, 30.0};
      }
    };
    pull(5.0);
    for (int k = 0; k < 100; ++k) smoothed.update(state, reference);
    const FeetMatrix before = unsmoothed.update(state, reference).forces;
    BOOST_TEST((smoothed.solution().forces - before).norm() < 0.01);
    pull(-5.0);
    const double jump = (unsmoothed.update(state, reference).forces - before).norm();
    const double step = (smoothed.update(state, reference).forces - before).norm();
    BOOST_TEST(jump > 5.0);
    BOOST_TEST(step < 0.2 * jump);
    for (int k = 0; k < 100; ++k) smoothed.update(state, reference);
    BOOST_TEST((smoothed.solution().forces - unsmoothed.solution().forces).norm() < 0.01);
  }
}

// Check the equations of motion with Pinocchio's own functions.
BOOST_AUTO_TEST_CASE(a_solution_satisfies_the_full_equations_of_motion_in_either_form) {
  const Robot robot = quadruped();
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    WholeBodyController controller(robot, Gains(), {form, 1e-10});
    for (int seed = 0; seed < 20; ++seed) {
      const RobotState state = random_state(robot, seed, 1.0);
      const Solution& solution = controller.update(state, reference_at(robot, state));
      BOOST_REQUIRE((solution.status == Status::kOk));
      BOOST_TEST((solution.form == form));
      Eigen::VectorXd residual = inverse_dynamics(robot, state, solution.accelerations);
      residual.tail(kMotors) -= solution.torques;
      const Dynamics dynamics = dynamics_at(robot, state);
      for (int leg = 0; leg < kLegs; ++leg) {
        const LegDynamics& L = dynamics.legs()[leg];
        const int first = robot.motor_to_v()[3 * leg];
        residual.head<6>() -= L.J_base.transpose() * solution.forces.col(leg);
        residual.segment<3>(first) -= L.J_leg.transpose() * solution.forces.col(leg);
      }
      BOOST_TEST(residual.cwiseAbs().maxCoeff() < 1e-6);
    }
  }
}

BOOST_AUTO_TEST_CASE(shifted_dynamics_give_the_same_solution) {
  const Robot robot = quadruped();
  for (const QpForm form : {QpForm::kCondensed, QpForm::kGeneral}) {
    for (const BodyPoint point : {BodyPoint::kCenterOfMass, BodyPoint::kBase}) {
      WholeBodyController direct(robot, Gains(), {form, 1e-12}),
          moved(robot, Gains(), {form, 1e-12});
      const RobotState state = random_state(robot, 4, 1.0);
      Reference reference = reference_at(robot, state);
      reference.body_point = point;
      RobotState resting = state;
      resting.q.head<3>().setZero();
      resting.v.head<3>().setZero();
      Dynamics shifted = dynamics_at(robot, resting);
      shifted.shift(state.q.head<3>(), dynamics_at(robot, state).v_world_base());
      const Solution& a = direct.update(state, reference);
      const Solution& b = moved.solve(shifted, state, reference);
      BOOST_REQUIRE((a.status == Status::kOk && b.status == Status::kOk));
      BOOST_TEST((a.torques - b.torques).norm() < 1e-8);
      BOOST_TEST((a.accelerations - b.accelerations).norm() < 1e-7);
    }
  }
}

BOOST_AUTO_TEST_CASE(reset_controller_gives_the_torques_of_a_new_one) {
  const Robot robot = quadruped();
  WholeBodyController used(robot), fresh(robot);
  for (int seed = 0; seed < 20; ++seed) {
    const RobotState state = random_state(robot, seed, 8.0);
    Reference reference = reference_at(robot, state);
    reference.a_com.z() = 60.0;
    used.update(state, reference);
  }
  used.reset();
  for (int seed = 20; seed < 40; ++seed) {
    const RobotState state = random_state(robot, seed, 8.0);
    const Reference reference = reference_at(robot, state);
    BOOST_TEST((used.update(state, reference).torques == fresh.update(state, reference).torques));
  }
}

BOOST_AUTO_TEST_SUITE_END()
