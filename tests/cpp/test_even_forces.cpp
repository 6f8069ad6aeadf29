// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <boost/test/unit_test.hpp>

#include "pushed_robot.hpp"
#include "tasks/even_forces.hpp"

using namespace surefoot;

namespace {

const Vector3 kForce(4.0, -3.0, 118.0);
const Vector3 kMoment(1.0, -0.5, 0.3);

// Sum of the forces and of their moments about the centre of mass, from the definition.
Eigen::Matrix<double, 6, 12> wrench_matrix(const Dynamics& dynamics) {
  Eigen::Matrix<double, 6, 12> A;
  for (int leg = 0; leg < kLegs; ++leg) {
    const Vector3 arm = dynamics.legs()[leg].p_world_contact - dynamics.p_world_com();
    for (int k = 0; k < 3; ++k) {
      A.col(3 * leg + k) << Vector3::Unit(k), arm.cross(Vector3::Unit(k));
    }
  }
  return A;
}

Vector6 wrench_vector() {
  Vector6 b;
  b << kForce, kMoment;
  return b;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(even_forces_)

BOOST_FIXTURE_TEST_CASE(even_forces_produce_the_wrench_with_minimum_norm, PushedRobot) {
  const Vector12 even = even_forces(dynamics, kForce, kMoment, Eigen::Vector4d::Ones());
  const Eigen::MatrixXd A = wrench_matrix(dynamics);
  BOOST_TEST((A * even - wrench_vector()).norm() < 1e-5);
  const Eigen::MatrixXd kernel = Eigen::FullPivLU<Eigen::MatrixXd>(A).kernel();
  BOOST_TEST((kernel.transpose() * even).cwiseAbs().maxCoeff() < 1e-6 * even.norm());
}

BOOST_FIXTURE_TEST_CASE(foot_with_zero_share_gets_no_even_force, PushedRobot) {
  const Vector12 even = even_forces(dynamics, kForce, kMoment, Eigen::Vector4d(1.0, 1.0, 0.0, 1.0));
  BOOST_TEST(even.segment<3>(3 * RR_).norm() == 0.0);
  BOOST_TEST((wrench_matrix(dynamics) * even - wrench_vector()).norm() < 1e-5);
}

BOOST_FIXTURE_TEST_CASE(shares_weight_the_minimum_norm_of_even_forces, PushedRobot) {
  const Eigen::Vector4d share(1.0, 0.5, 0.2, 0.8);
  const Vector12 even = even_forces(dynamics, kForce, kMoment, share);
  BOOST_TEST((wrench_matrix(dynamics) * even - wrench_vector()).norm() < 1e-5);
  // Stationarity: the gradient of sum |f|^2 / share is orthogonal to the kernel of the wrench
  // matrix.
  Vector12 gradient = even;
  for (int leg = 0; leg < kLegs; ++leg) gradient.segment<3>(3 * leg) /= share[leg];
  const Eigen::MatrixXd kernel =
      Eigen::FullPivLU<Eigen::MatrixXd>(wrench_matrix(dynamics)).kernel();
  BOOST_TEST((kernel.transpose() * gradient).cwiseAbs().maxCoeff() < 1e-6 * gradient.norm());
}

BOOST_FIXTURE_TEST_CASE(even_forces_stay_finite_on_two_or_no_feet, PushedRobot) {
  const Vector12 two = even_forces(dynamics, kForce, kMoment, Eigen::Vector4d(1.0, 0.0, 0.0, 1.0));
  BOOST_TEST(two.allFinite());
  BOOST_TEST(two.norm() < 1e4);
  BOOST_TEST(even_forces(dynamics, kForce, kMoment, Eigen::Vector4d::Zero()).norm() == 0.0);
}

BOOST_AUTO_TEST_CASE(turning_moment_is_the_momentum_rate_with_locked_joints) {
  PushedRobot locked;
  locked.state.v.tail(kMotors).setZero();
  locked.state.v.segment<3>(3) = Vector3(1.0, -2.0, 0.5);
  locked.a.setZero();
  locked.a.segment<3>(3) = Vector3(3.0, 2.0, -4.0);
  const Dynamics dynamics = dynamics_at(locked.robot, locked.state);
  const Vector3 measured_rate = locked.rate([](const Dynamics& d) { return d.L_world_com(); });
  const Vector3 alpha = dynamics.R_world_base() * locked.a.segment<3>(3);
  BOOST_TEST((turning_moment(dynamics, alpha) - measured_rate).norm() < 1e-6);
}

BOOST_AUTO_TEST_SUITE_END()
