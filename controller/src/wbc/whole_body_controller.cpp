// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/whole_body_controller.hpp"

#include "tasks/base_orientation_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/foot_task.hpp"
#include "tasks/force_task.hpp"
#include "wbc/whole_body_program.hpp"

namespace surefoot {

struct WholeBodyController::Impl {
  Impl(const Robot& r, const Gains& g)
      : robot(r),
        gains(g),
        dynamics(r),
        program(r),
        solver(WholeBodyProgram::kForces, WholeBodyProgram::kRows),
        solution(r.nv()) {
    gains.validate();
  }
  Eigen::Vector4d normal_force_limits(const Eigen::Vector4d& contact,
                                      const Reference& reference) const noexcept;
  Eigen::Vector4d load_shares(const Eigen::Vector4d& contact,
                              const Reference& reference) const noexcept;
  Eigen::Matrix<double, kMotors, 2> torque_limits(const Vector12& dq) const noexcept;
  void write_solution(const Vector12& forces,
                      const Eigen::Matrix<double, kMotors, 2>& limits) noexcept;

  Robot robot;
  Gains gains;
  Dynamics dynamics;
  Condensed condensed;
  WholeBodyProgram program;
  QpSolver solver;
  Solution solution;
};

WholeBodyController::WholeBodyController(const Robot& robot)
    : WholeBodyController(robot, robot.config().gains) {}
WholeBodyController::WholeBodyController(const Robot& robot, const Gains& gains)
    : impl_(std::make_unique<Impl>(robot, gains)) {}
WholeBodyController::~WholeBodyController() = default;
WholeBodyController::WholeBodyController(WholeBodyController&&) noexcept = default;

const Solution& WholeBodyController::solution() const noexcept { return impl_->solution; }
const Gains& WholeBodyController::gains() const noexcept { return impl_->gains; }
void WholeBodyController::reset() noexcept { impl_->solver.reset(); }

void WholeBodyController::set_gains(const Gains& gains) {
  gains.validate();
  impl_->gains = gains;
}

const Solution& WholeBodyController::update(const RobotState& state,
                                            const Reference& reference) noexcept {
  Impl& s = *impl_;
  if (state.q.size() != s.robot.nq() || state.v.size() != s.robot.nv()) {
    s.solution.status = Status::kWrongSize;
    return s.solution;
  }
  if (!state.q.allFinite() || !state.v.allFinite() || !state.contact.allFinite()) {
    s.solution.status = Status::kNonFinite;
    return s.solution;
  }
  s.dynamics.update(state.q, state.v, reference.ground_normal);
  Vector12 dq;
  for (int i = 0; i < kMotors; ++i) dq[i] = state.v[s.robot.motor_to_v()[i]];
  return solve(s.dynamics, state.contact, dq, reference);
}

const Solution& WholeBodyController::solve(const Dynamics& dynamics, const Eigen::Vector4d& contact,
                                           const Vector12& dq_motor,
                                           const Reference& reference) noexcept {
  Impl& s = *impl_;
  // Feet first: their accelerations are met exactly and fix what is left to choose.
  if (!condense(dynamics, feet_accelerations(s.gains, reference, dynamics),
                s.program.smallest_determinant(), s.condensed)) {
    s.solution.status = Status::kSingular;
    return s.solution;
  }
  const TaskRows com =
      com_task(s.gains, com_acceleration(s.gains, reference, dynamics), s.robot.mass());
  const TaskRows orientation = base_orientation_task(
      s.gains, base_angular_acceleration(s.gains, reference, dynamics), dynamics, s.condensed);

  const Eigen::Vector4d normal_limits = s.normal_force_limits(contact, reference);
  const Eigen::Vector4d share = s.load_shares(contact, reference);
  const auto limits = s.torque_limits(dq_motor);
  s.program.set_cost(s.gains, com, orientation, even_forces(com, orientation, share));
  s.program.set_friction(reference.ground_normal, s.robot.config().friction, normal_limits);
  s.program.set_torque_limits(s.condensed, limits);

  const QpResult result = s.solver.solve(s.program.problem());
  s.solution.status = result.status;
  s.solution.iterations = result.iterations;
  s.solution.primal_residual = result.primal_residual;
  s.solution.dual_residual = result.dual_residual;
  if (result.status == Status::kOk) {
    s.write_solution(s.program.force_unit() * s.solver.x(), limits);
    s.solution.accelerations.head<3>() += dynamics.a_base_shift();
  }
  return s.solution;
}

// A foot's greatest normal force goes smoothly with the belief that it is on the ground, never to
// nothing while it is meant to stand: a foot wrongly believed lifted must be able to show its load.
Eigen::Vector4d WholeBodyController::Impl::normal_force_limits(
    const Eigen::Vector4d& contact, const Reference& reference) const noexcept {
  Eigen::Vector4d limits;
  const double weight = robot.mass() * kGravity;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double belief = std::min(std::max(contact[leg], 0.0), 1.0);
    const double limit =
        gains.force_lost_contact + belief * (gains.force_max_contact - gains.force_lost_contact);
    limits[leg] = reference.feet[leg].stance ? limit * weight : 0.0;
  }
  return limits;
}

Eigen::Vector4d WholeBodyController::Impl::load_shares(const Eigen::Vector4d& contact,
                                                       const Reference& reference) const noexcept {
  Eigen::Vector4d shares;
  for (int leg = 0; leg < kLegs; ++leg) {
    const double belief = std::min(std::max(contact[leg], 0.0), 1.0);
    const double share = gains.share_lost_contact + belief * (1.0 - gains.share_lost_contact);
    shares[leg] = reference.feet[leg].stance ? share : 0.0;
  }
  return shares;
}

Eigen::Matrix<double, kMotors, 2> WholeBodyController::Impl::torque_limits(
    const Vector12& dq) const noexcept {
  Eigen::Matrix<double, kMotors, 2> limits;
  for (int i = 0; i < kMotors; ++i) {
    limits(i, 0) = -motor_torque_limit(robot.config(), i, dq[i], -1.0);
    limits(i, 1) = motor_torque_limit(robot.config(), i, dq[i], 1.0);
  }
  return limits;
}

void WholeBodyController::Impl::write_solution(
    const Vector12& forces, const Eigen::Matrix<double, kMotors, 2>& limits) noexcept {
  const Vector6 a_base = condensed.B * forces + condensed.c;
  const Vector12 a_legs = condensed.leg_accelerations(a_base);
  const Vector12 tau =
      (condensed.T * forces + condensed.t0).cwiseMax(limits.col(0)).cwiseMin(limits.col(1));
  solution.accelerations.head<6>() = a_base;
  for (int i = 0; i < kMotors; ++i) {
    solution.accelerations[robot.motor_to_v()[i]] = a_legs[i];
    solution.torques[robot.motor_to_v()[i] - 6] = tau[i];
  }
  for (int leg = 0; leg < kLegs; ++leg) solution.forces.col(leg) = forces.segment<3>(3 * leg);
}

}  // namespace surefoot
