// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>

#include "pushed_robot.hpp"
#include "wbc/condensed_qp.hpp"
#include "wbc/qp_terms_writer.hpp"
#include "wbc/qp_units.hpp"

using namespace surefoot;

BOOST_AUTO_TEST_SUITE(condensation)

BOOST_AUTO_TEST_CASE(condensed_motion_satisfies_the_full_equations_for_any_forces) {
  const Robot robot = quadruped();
  for (int seed = 0; seed < 20; ++seed) {
    const RobotState state = random_state(robot, seed, 1.0);
    Dynamics dynamics(robot);
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    std::srand(static_cast<unsigned>(seed));
    const FeetMatrix foot_accelerations = FeetMatrix::Random();
    const Vector6 external_wrench = 20.0 * Vector6::Random();  // a wrench on the base
    Condensed condensed;
    BOOST_REQUIRE(condense(dynamics, foot_accelerations, external_wrench, 1e-6, condensed));
    const Vector12 f = 50.0 * Vector12::Random();
    Eigen::VectorXd a(robot.nv());
    a.head<6>() = condensed.B * f + condensed.c;
    const Vector12 legs = condensed.leg_accelerations(a.head<6>());
    const Vector12 tau = condensed.T * f + condensed.t0;
    for (int i = 0; i < kMotors; ++i) a[robot.motor_to_v()[i]] = legs[i];

    Eigen::VectorXd residual = inverse_dynamics(robot, state, a);
    residual.head<6>() -= external_wrench;
    for (int leg = 0; leg < kLegs; ++leg) {
      const LegDynamics& L = dynamics.legs()[leg];
      const int first = robot.motor_to_v()[3 * leg];
      residual.head<6>() -= L.J_base.transpose() * f.segment<3>(3 * leg);
      residual.segment<3>(first) -= L.J_leg.transpose() * f.segment<3>(3 * leg);
      residual.segment<3>(first) -= tau.segment<3>(3 * leg);
      const Vector3 accel = L.J_base * a.head<6>() + L.J_leg * a.segment<3>(first) + L.drift;
      BOOST_TEST((accel - foot_accelerations.col(leg)).norm() < 1e-8);
    }
    BOOST_TEST(residual.cwiseAbs().maxCoeff() < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(the_cost_is_scaled_and_well_conditioned_at_default_gains) {
  const Robot robot = quadruped();
  QpTermsWriter writer(robot);
  CondensedQp qp(make_joint_table(robot), QpUnits(robot));
  for (int seed = 0; seed < 50; ++seed) {
    const RobotState state = random_state(robot, seed);
    const Dynamics dynamics = dynamics_at(robot, state);
    BOOST_REQUIRE((writer.write(Gains(), dynamics, state, reference_at(robot, state),
                                Eigen::Vector4d::Zero(), nullptr) == Status::kOk));
    BOOST_REQUIRE(writer.terms().has_condensed);
    qp.build(writer.terms());
    const Eigen::MatrixXd H = qp.problem().H;
    BOOST_TEST(std::abs(H.trace() - 12.0) < 1e-9);
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues();
    BOOST_TEST(eigenvalues.maxCoeff() / eigenvalues.minCoeff() <= 200.0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
