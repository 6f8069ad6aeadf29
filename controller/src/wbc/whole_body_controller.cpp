// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/whole_body_controller.hpp"

#include "surefoot/error.hpp"
#include "tasks/base_orientation_task.hpp"
#include "tasks/com_task.hpp"
#include "tasks/foot_task.hpp"
#include "tasks/force_task.hpp"
#include "wbc/limits.hpp"
#include "wbc/whole_body_program.hpp"

namespace surefoot {

namespace {

constexpr double kQuaternionTolerance = 1e-3;  // unit quaternions and normals are relied on

bool finite(const Reference& r) noexcept {
  bool good = r.p_com.allFinite() && r.v_com.allFinite() && r.a_com.allFinite() &&
              r.R_world_base.coeffs().allFinite() && r.w_world_base.allFinite() &&
              r.alpha_world_base.allFinite() && r.ground_normal.allFinite();
  for (const FootReference& foot : r.feet) {
    good = good && foot.p_world.allFinite() && foot.v_world.allFinite() && foot.a_world.allFinite();
  }
  return good;
}

bool sound(const Reference& r) noexcept {
  return std::abs(r.R_world_base.norm() - 1.0) <= kQuaternionTolerance &&
         std::abs(r.ground_normal.norm() - 1.0) <= kQuaternionTolerance &&
         r.ground_normal.z() > 0.1;
}

}  // namespace

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
  void write_solution(const Vector12& forces, const TorqueLimits& limits) noexcept;

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
  if (!state.q.allFinite() || !state.v.allFinite() || !state.contact.allFinite() ||
      !finite(reference)) {
    s.solution.status = Status::kNonFinite;
    return s.solution;
  }
  if (!sound(reference)) {
    s.solution.status = Status::kBadReference;
    return s.solution;
  }
  if (std::abs(state.q.segment<4>(3).norm() - 1.0) > kQuaternionTolerance) {
    s.solution.status = Status::kBadQuaternion;
    return s.solution;
  }
  s.dynamics.update(state.q, state.v, reference.ground_normal);
  Vector12 dq;
  for (int i = 0; i < kMotors; ++i) dq[i] = state.v[s.robot.motor_to_v()[i]];
  return solve(s.dynamics, state.contact, dq, reference);
}

Reference WholeBodyController::hold(const RobotState& state) {
  Impl& s = *impl_;
  if (state.q.size() != s.robot.nq() || state.v.size() != s.robot.nv()) {
    throw Error("hold: got q of " + std::to_string(state.q.size()) + " and v of " +
                std::to_string(state.v.size()) + ", expected " + std::to_string(s.robot.nq()) +
                " and " + std::to_string(s.robot.nv()));
  }
  Reference reference;
  s.dynamics.update(state.q, state.v, reference.ground_normal);
  reference.p_com = s.dynamics.p_world_com();
  reference.R_world_base = Quaternion(s.dynamics.R_world_base());
  for (int leg = 0; leg < kLegs; ++leg) {
    reference.feet[leg].p_world = s.dynamics.legs()[leg].p_world_contact;
  }
  return reference;
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

  const double weight = s.robot.mass() * kGravity;
  const Eigen::Vector4d normal_limits = normal_force_limits(s.gains, weight, contact, reference);
  const Eigen::Vector4d share = load_shares(s.gains, contact, reference);
  const auto limits = torque_limits(s.robot.config(), dq_motor);
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

void WholeBodyController::Impl::write_solution(const Vector12& forces,
                                               const TorqueLimits& limits) noexcept {
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
