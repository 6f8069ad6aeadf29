// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <boost/test/unit_test.hpp>

#include "quadruped.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "tasks/base_orientation_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/force_task.hpp"
#include "wbc/whole_body_program.hpp"

using namespace surefoot;

namespace {

struct RandomProgram {
  QpProblem problem{12, 72};
  explicit RandomProgram(int seed) {
    std::srand(static_cast<unsigned>(seed));
    const Eigen::MatrixXd A = Eigen::MatrixXd::Random(12, 6);
    problem.H = A * A.transpose() + 0.05 * Eigen::MatrixXd::Identity(12, 12);
    problem.H *= 12.0 / problem.H.trace();
    problem.g = 2.0 * Eigen::VectorXd::Random(12);
    problem.C = Eigen::MatrixXd::Random(72, 12);
    problem.l = -0.2 * Eigen::VectorXd::Ones(72) + 0.2 * Eigen::VectorXd::Random(72);
    problem.u = 0.3 * Eigen::VectorXd::Ones(72) + 0.2 * Eigen::VectorXd::Random(72);
    problem.l.head(36).setConstant(-1e20);
  }
};

// Karush, Kuhn and Tucker, written here from the definition.
double kkt_residual(const QpProblem& p, const Eigen::VectorXd& x, const Eigen::VectorXd& z) {
  double worst = (p.H * x + p.g + p.C.transpose() * z).cwiseAbs().maxCoeff();
  const Eigen::VectorXd Cx = p.C * x;
  for (Eigen::Index i = 0; i < Cx.size(); ++i) {
    worst = std::max({worst, Cx[i] - p.u[i], p.l[i] - Cx[i]});
    if (z[i] > 1e-9) worst = std::max(worst, z[i] * std::abs(p.u[i] - Cx[i]));
    if (z[i] < -1e-9) worst = std::max(worst, -z[i] * std::min(1.0, std::abs(Cx[i] - p.l[i])));
  }
  return worst;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(wbc)

BOOST_AUTO_TEST_CASE(every_accepted_answer_satisfies_kkt_warm_or_cold) {
  QpSolver solver(12, 72);
  for (int seed = 0; seed < 300; ++seed) {
    const RandomProgram random(seed);
    const QpResult result = solver.solve(random.problem);
    BOOST_TEST((result.status == Status::kOk));
    BOOST_TEST(kkt_residual(random.problem, solver.x(), solver.z()) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_program_that_is_not_finite_is_refused_and_the_next_is_solved) {
  QpSolver solver(12, 72);
  for (int field = 0; field < 5; ++field) {
    RandomProgram random(field);
    Eigen::VectorXd* vectors[] = {&random.problem.g, &random.problem.l, &random.problem.u};
    if (field < 3) (*vectors[field])[3] = std::nan("");
    if (field == 3) random.problem.H(1, 2) = std::nan("");
    if (field == 4) random.problem.C(1, 2) = std::numeric_limits<double>::infinity();
    BOOST_TEST((solver.solve(random.problem).status == Status::kNonFinite));
    BOOST_TEST((solver.solve(RandomProgram(field).problem).status == Status::kOk));
  }
}

BOOST_AUTO_TEST_CASE(the_pyramid_is_inside_the_cone_and_loses_at_most_three_percent) {
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

BOOST_AUTO_TEST_CASE(condensed_motion_satisfies_the_full_equations_for_any_forces) {
  const Robot robot = quadruped();
  for (int seed = 0; seed < 20; ++seed) {
    const RobotState state = random_state(robot, seed, 1.0);
    Dynamics dynamics(robot);
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    std::srand(static_cast<unsigned>(seed));
    const FeetMatrix wanted = FeetMatrix::Random();
    Condensed condensed;
    BOOST_REQUIRE(condense(dynamics, wanted, 1e-6, condensed));
    const Vector12 f = 50.0 * Vector12::Random();
    Eigen::VectorXd a(robot.nv());
    a.head<6>() = condensed.B * f + condensed.c;
    const Vector12 legs = condensed.leg_accelerations(a.head<6>());
    const Vector12 tau = condensed.T * f + condensed.t0;
    for (int i = 0; i < kMotors; ++i) a[robot.motor_to_v()[i]] = legs[i];

    Eigen::VectorXd left = inverse_dynamics(robot, state, a);
    for (int leg = 0; leg < kLegs; ++leg) {
      const LegDynamics& L = dynamics.legs()[leg];
      const int first = robot.motor_to_v()[3 * leg];
      left.head<6>() -= L.J_base.transpose() * f.segment<3>(3 * leg);
      left.segment<3>(first) -= L.J_leg.transpose() * f.segment<3>(3 * leg);
      left.segment<3>(first) -= tau.segment<3>(3 * leg);
      const Vector3 accel = L.J_base * a.head<6>() + L.J_leg * a.segment<3>(first) + L.drift;
      BOOST_TEST((accel - wanted.col(leg)).norm() < 1e-8);
    }
    BOOST_TEST(left.cwiseAbs().maxCoeff() < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(a_straight_leg_is_reported_singular) {
  const Robot robot = quadruped();
  RobotState state = random_state(robot, 0);
  state.q[robot.motor_to_q()[FL_2]] = 0.0;
  WholeBodyController controller(robot);
  BOOST_TEST((controller.update(state, reference_at(robot, state)).status == Status::kSingular));
}

BOOST_AUTO_TEST_CASE(the_cost_is_scaled_and_well_conditioned_at_default_gains) {
  const Robot robot = quadruped();
  for (int seed = 0; seed < 50; ++seed) {
    const RobotState state = random_state(robot, seed);
    Dynamics dynamics(robot);
    dynamics.update(state.q, state.v, Vector3::UnitZ());
    Condensed condensed;
    BOOST_REQUIRE(condense(dynamics, FeetMatrix::Zero(), 1e-6, condensed));
    WholeBodyProgram program(robot);
    const Gains gains;
    program.set_cost(gains, com_task(gains, Vector3::Zero(), robot.mass()),
                     base_orientation_task(gains, Vector3::Zero(), dynamics, condensed),
                     Vector12::Zero());
    const Eigen::MatrixXd H = program.problem().H;
    BOOST_TEST(std::abs(H.trace() - 12.0) < 1e-9);
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues();
    BOOST_TEST(eigenvalues.maxCoeff() / eigenvalues.minCoeff() < 200.0);
  }
}

BOOST_AUTO_TEST_CASE(torques_stay_inside_the_motors_whatever_is_asked) {
  const Robot robot = quadruped();
  WholeBodyController controller(robot);
  for (int seed = 0; seed < 100; ++seed) {
    const RobotState state = random_state(robot, seed, 10.0);
    Reference reference = reference_at(robot, state);
    reference.a_com = 100.0 * Vector3(seed % 3 - 1, seed % 5 - 2, seed % 7 - 3);
    const Solution& solution = controller.update(state, reference);
    BOOST_TEST((solution.status == Status::kOk));
    for (int i = 0; i < kMotors; ++i) {
      const double tau = solution.torques[robot.motor_to_v()[i] - 6];
      const double dq = state.v[robot.motor_to_v()[i]];
      BOOST_TEST(std::abs(tau) <= motor_torque_limit(robot.config(), i, dq, tau) + 1e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_same_inputs_give_the_same_bits) {
  const Robot robot = quadruped();
  WholeBodyController a(robot), b(robot);
  for (int seed = 0; seed < 20; ++seed) {
    const RobotState state = random_state(robot, seed, 1.0);
    const Reference reference = reference_at(robot, state);
    BOOST_TEST((a.update(state, reference).torques == b.update(state, reference).torques));
  }
}

BOOST_AUTO_TEST_SUITE_END()
