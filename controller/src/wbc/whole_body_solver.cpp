// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/whole_body_solver.hpp"

#include "surefoot/error.hpp"
#include "surefoot/stage_clock.hpp"
#include "wbc/released_legs.hpp"

namespace surefoot {

namespace {

// A motor counts as saturated if its torque is closer to the limit than this share of tau_max.
// Numerical: residuals of 5e-6 (QP units) change a torque by less than this.
constexpr double kSaturated = 1e-3;
// Curvature of the slacks' cost, before scaling. Chosen larger than 0, so that the QP is strictly
// convex. The linear penalties (gains penalty_*) make the constraints exact.
constexpr double kCurvature = 1.0;
// Smallest value to which solve() reduces the tolerance for heavy user tasks. An option `tolerance`
// below this value is used without reduction. Numerical: rounding errors allow no smaller
// tolerance. Test: both_methods_meet_a_tolerance_of_1e_minus_12.
constexpr double kMinTolerance = 1e-12;
// A cold solve multiplies the tolerance by this factor. Chosen larger than 1, because the solve
// before it has failed with the tolerance itself. An error of 1e-5 (QP units) is far below 1 N.
// Test: cold_solve_accepts_residuals_up_to_10_times_the_tolerance.
constexpr double kColdToleranceFactor = 10.0;
// Smallest accepted share of the built-in tasks in trace(H); user tasks have the rest. Derived:
// with the default tolerance 1e-6, the reduced tolerance is then at least ten times kMinTolerance.
constexpr double kMinBuiltInShare = 1e-5;

ElasticRows elastic_rows(const JointTable& joints) {
  const QpLayout layout(static_cast<int>(joints.size()));
  ElasticRows rows;
  rows.groups = QpLayout::kGroups;
  rows.group.assign(layout.rows(), -1);
  for (int leg = 0; leg < kLegs; ++leg) {
    rows.group[layout.hold_down() + leg] = QpLayout::hold_down_group(leg);
  }
  for (int k = 0; k < layout.joints; ++k) {
    rows.group[layout.torque() + k] = QpLayout::torque_group(joints[k].group);
    rows.group[layout.acceleration() + k] = QpLayout::acceleration_group(joints[k].group);
  }
  return rows;
}

JointTable motors_only(const JointTable& joints) {
  return JointTable(joints.begin(), joints.begin() + kMotors);
}

}  // namespace

WholeBodySolver::WholeBodySolver(const Robot& robot, const WholeBodyOptions& options)
    : robot_(robot),
      options_(options),
      joints_(make_joint_table(robot)),
      units_(robot),
      selector_(units_.smallest_determinant),
      condensed_(joints_, units_),
      general_(robot.nv(), joints_, units_),
      condensed_solver_(QpLayout::kForces, 0, elastic_rows(motors_only(joints_)),
                        options.tolerance),
      general_solver_(robot.nv() + QpLayout::kForces, 6 + QpLayout::kForces, elastic_rows(joints_),
                      options.tolerance),
      penalty_(Eigen::VectorXd::Zero(QpLayout::kGroups)),
      accelerations_(Eigen::VectorXd::Zero(robot.nv())),
      torques_(Eigen::VectorXd::Zero(robot.nv() - 6)) {
  if (options.form == QpForm::kCondensed && !Dynamics(robot).condensable()) {
    throw Error("robot '" + robot.config().name +
                "': the condensed form got nv = " + std::to_string(robot.nv()) +
                ", expected 18: a free base and four chains of three joints (hip, thigh, calf); "
                "use form 'general' or 'auto', or make other joints fixed");
  }
}

void WholeBodySolver::reset() noexcept {
  condensed_solver_.reset();
  general_solver_.reset();
  selector_ = FormSelector(units_.smallest_determinant);
}

const Eigen::Vector4d& WholeBodySolver::select_form(const Dynamics& dynamics,
                                                    const Reference& reference) noexcept {
  form_ = selector_.update(dynamics, reference, options_.form);
  return selector_.softness();
}

const QpProblem& WholeBodySolver::problem() const noexcept {
  return form_ == QpForm::kCondensed ? condensed_.problem() : general_.problem();
}

const ElasticSolver& WholeBodySolver::elastic() const noexcept {
  return form_ == QpForm::kCondensed ? condensed_solver_ : general_solver_;
}

ElasticSolver& WholeBodySolver::elastic() noexcept {
  return form_ == QpForm::kCondensed ? condensed_solver_ : general_solver_;
}

const QpProblem& WholeBodySolver::solved_problem() const noexcept {
  return elastic().solved_problem(problem());
}

void WholeBodySolver::solve(const Gains& gains, const Dynamics& dynamics, const QpTerms& terms,
                            Solution& out) noexcept {
  const StageScope stage(Stage::kQpAssembly);
  const bool condensed = form_ == QpForm::kCondensed;
  if (condensed && !terms.has_condensed) {
    out.status = Status::kSingular;
    return;
  }
  if (condensed) {
    condensed_.build(terms);
  } else {
    general_.build(dynamics, terms);
  }
  const double scale = condensed ? condensed_.cost_scale() : general_.cost_scale();
  penalty_.head<kLegs>().setConstant(scale * gains.penalty_hold_down);
  penalty_.segment<QpLayout::kLegGroups>(kLegs).setConstant(scale * gains.penalty_torque);
  penalty_.tail<QpLayout::kLegGroups>().setConstant(scale * gains.penalty_joint_limit);
  // The cost is scaled to trace(H) = n, so heavy user tasks make all other tasks small. The
  // tolerance shrinks by the same share, so that the other tasks are still solved accurately.
  const double built_in_share = condensed ? condensed_.built_in_share() : general_.built_in_share();
  if (!(built_in_share >= kMinBuiltInShare)) {
    out.status = Status::kBadTask;
    return;
  }
  curvature_ = scale * kCurvature;
  tolerance_ =
      std::max(built_in_share * options_.tolerance, std::min(options_.tolerance, kMinTolerance));
  elastic().set_tolerance(tolerance_);
  store_result(elastic().solve(problem(), penalty_, curvature_), dynamics, terms, out);
}

void WholeBodySolver::solve_cold(const Dynamics& dynamics, const QpTerms& terms,
                                 Solution& out) noexcept {
  const StageScope stage(Stage::kQpAssembly);
  elastic().set_tolerance(kColdToleranceFactor * tolerance_);
  store_result(elastic().solve_cold(problem(), penalty_, curvature_), dynamics, terms, out);
}

void WholeBodySolver::store_result(const QpResult& result, const Dynamics& dynamics,
                                   const QpTerms& terms, Solution& out) noexcept {
  out.status = result.status;
  out.iterations = result.iterations;
  out.primal_residual = result.primal_residual;
  out.dual_residual = result.dual_residual;
  if (result.status != Status::kOk) return;
  if (form_ == QpForm::kCondensed) {
    condensed_.read_solution(elastic().x(), forces_, accelerations_, torques_);
  } else {
    general_.read_solution(elastic().x(), forces_, accelerations_, torques_);
  }
  out.form = form_;
  clamp_released_legs(joints_, dynamics, terms.limits, accelerations_, torques_);
  write_solution(dynamics, terms.limits, out);
}

void WholeBodySolver::write_solution(const Dynamics& dynamics, const JointLimits& limits,
                                     Solution& out) noexcept {
  const Eigen::VectorXd& slack = elastic().slack();
  out.accelerations = accelerations_;
  out.accelerations.head<3>() += dynamics.a_base_shift();
  out.forces = Eigen::Map<const FeetMatrix>(forces_.data());
  out.clipped_torque = 0.0;
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const double tau = std::min(std::max(torques_[k], limits.tau_lower[k]), limits.tau_upper[k]);
    const double clipped = std::abs(tau - torques_[k]);
    out.clipped_torque = std::max(out.clipped_torque, clipped);
    const double near = kSaturated * joints_[k].tau_max;
    if (clipped > near || limits.tau_upper[k] - tau < near || tau - limits.tau_lower[k] < near) {
      out.status = Status::kSaturated;
    }
    out.torques[joints_[k].v - 6] = tau;
  }
  out.hold_down_violation = units_.force * slack.head<kLegs>().maxCoeff();
  out.torque_limit_violation = slack.segment<QpLayout::kLegGroups>(kLegs).maxCoeff();
  out.joint_limit_violation = units_.angular * slack.tail<QpLayout::kLegGroups>().maxCoeff();
}

}  // namespace surefoot
