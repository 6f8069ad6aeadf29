// SPDX-License-Identifier: BSD-3-Clause
#include "surefoot/whole_body_controller.hpp"

#include <algorithm>

#include "common/text.hpp"
#include "surefoot/error.hpp"
#include "wbc/input_check.hpp"
#include "wbc/qp_terms_writer.hpp"
#include "wbc/whole_body_solver.hpp"

namespace surefoot {

namespace {
// Largest number of rows of a user task; chosen far larger than any robot's nv.
constexpr int kMaxTaskRows = 1000;
}  // namespace

void WholeBodyOptions::validate() const {
  if (!(tolerance >= 1e-14 && tolerance <= 1e-3)) {
    throw Error("option 'tolerance' out of range: got " + to_text(tolerance) +
                ", expected 1e-14 .. 1e-3");
  }
}

struct WholeBodyController::Impl {
  Impl(const Robot& r, const Gains& g, const WholeBodyOptions& options)
      : robot(r),
        gains(g),
        joints(make_joint_table(r)),
        dynamics(r),
        writer(r),
        solver((options.validate(), r), options),
        solution(r.nv()) {
    gains.validate();
  }
  Robot robot;
  Gains gains;
  JointTable joints;
  Dynamics dynamics;
  QpTermsWriter writer;
  WholeBodySolver solver;
  Solution solution;
};

WholeBodyController::WholeBodyController(const Robot& robot)
    : WholeBodyController(robot, robot.config().gains) {}
WholeBodyController::WholeBodyController(const Robot& robot, const Gains& gains,
                                         const WholeBodyOptions& options)
    : impl_(std::make_unique<Impl>(robot, gains, options)) {}
WholeBodyController::~WholeBodyController() = default;
WholeBodyController::WholeBodyController(WholeBodyController&&) noexcept = default;

const Solution& WholeBodyController::solution() const noexcept { return impl_->solution; }
const QpProblem& WholeBodyController::qp() const noexcept { return impl_->solver.solved_problem(); }
const Gains& WholeBodyController::gains() const noexcept { return impl_->gains; }
void WholeBodyController::reset() noexcept {
  impl_->solver.reset();
  impl_->solution.status = Status::kWaiting;
  impl_->solution.forces.setZero();
}

void WholeBodyController::set_gains(const Gains& gains) {
  gains.validate();
  impl_->gains = gains;
}

bool WholeBodyController::adopt_gains(const Gains& gains) noexcept {
  if (!gains.valid()) return false;
  impl_->gains = gains;
  return true;
}

void WholeBodyController::set_torque_share(const Vector12& share) noexcept {
  if ((share.array() >= 0.0).all() && (share.array() <= 1.0).all()) {
    impl_->writer.set_torque_share(share);
  }
}

const Vector12& WholeBodyController::torque_share() const noexcept {
  return impl_->writer.torque_share();
}

void WholeBodyController::add_task(std::shared_ptr<Task> task) {
  const int rows = task == nullptr ? 0 : task->rows();
  if (rows < 1 || rows > kMaxTaskRows) {
    throw Error("add_task: got " +
                (task ? "a task of " + std::to_string(rows) + " rows" : std::string("no task")) +
                ", expected a task whose rows() is 1 .. " + std::to_string(kMaxTaskRows));
  }
  impl_->writer.add_task(std::move(task), rows);
}

const Solution& WholeBodyController::update(const RobotState& state,
                                            const Reference& reference) noexcept {
  Impl& s = *impl_;
  Status status = check_state(state, s.robot);
  if (status == Status::kOk) status = check_reference(reference, s.robot);
  if (status != Status::kOk) {
    s.solution.status = status;
    return s.solution;
  }
  s.dynamics.set_joints(state);
  s.dynamics.update(state.q, state.v, reference.ground_normal);
  return solve(s.dynamics, state, reference);
}

Reference WholeBodyController::hold(const RobotState& state) {
  Impl& s = *impl_;
  if (check_state(state, s.robot) != Status::kOk) {
    throw Error("hold: invalid state: got q of size " + std::to_string(state.q.size()) +
                " and v of size " + std::to_string(state.v.size()) + ", expected sizes " +
                std::to_string(s.robot.nq()) + " and " + std::to_string(s.robot.nv()) +
                ", all values finite, contact and friction in 0 .. 1, and a unit quaternion in q");
  }
  Reference reference;
  s.dynamics.update(state.q, state.v, reference.ground_normal);
  reference.p_com = s.dynamics.p_world_com();
  reference.p_base = s.dynamics.p_world_base();
  reference.R_world_base = Quaternion(s.dynamics.R_world_base());
  reference.posture = Eigen::VectorXd::Zero(s.robot.nv() - 6);
  for (const JointRow& joint : s.joints) {
    if (joint.q >= 0) reference.posture[joint.v - 6] = state.q[joint.q];
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    reference.feet[leg].p_world = s.dynamics.legs()[leg].p_world_contact;
  }
  return reference;
}

// The form is selected before the terms are written, because the terms depend on the softness of
// the feet.
const Solution& WholeBodyController::solve(const Dynamics& dynamics, const RobotState& state,
                                           const Reference& reference) noexcept {
  Impl& s = *impl_;
  const Eigen::Vector4d& softness = s.solver.select_form(dynamics, reference);
  const FeetMatrix* previous = s.solution.forces.isZero() ? nullptr : &s.solution.forces;
  const Status write_status =
      s.writer.write(s.gains, dynamics, state, reference, softness, previous);
  if (write_status != Status::kOk) {
    s.solution.status = write_status;
    return s.solution;
  }
  s.solver.solve(s.gains, dynamics, s.writer.terms(), s.solution);
  return s.solution;
}

const Solution& WholeBodyController::solve_cold(const Dynamics& dynamics) noexcept {
  Impl& s = *impl_;
  const Status previous_status = s.solution.status;
  if (previous_status == Status::kMaxIterations || previous_status == Status::kInfeasible) {
    s.solver.solve_cold(dynamics, s.writer.terms(), s.solution);
  }
  return s.solution;
}

}  // namespace surefoot
