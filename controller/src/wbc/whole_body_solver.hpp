// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/whole_body_controller.hpp"
#include "wbc/condensed_qp.hpp"
#include "wbc/elastic_solver.hpp"
#include "wbc/form_selector.hpp"
#include "wbc/general_qp.hpp"
#include "wbc/qp_units.hpp"

namespace surefoot {

/// Selects the form of the QP, builds and solves it, and converts the result to a Solution.
///
/// select_form() must run before the terms are written, because the terms depend on the softness of
/// the feet. Real-time: all functions except the constructor.
class WholeBodySolver {
 public:
  /// Throw surefoot::Error if the options require the condensed form and it is not valid for the
  /// robot.
  WholeBodySolver(const Robot& robot, const WholeBodyOptions& options);

  /// Select the form. @return the softness of each foot, 0 .. 1, see FormSelector
  const Eigen::Vector4d& select_form(const Dynamics& dynamics, const Reference& reference) noexcept;

  /// Build and solve the QP in the selected form. On failure, only status, iterations and residuals
  /// of `out` change.
  void solve(const Gains& gains, const Dynamics& dynamics, const QpTerms& terms,
             Solution& out) noexcept;

  /// Solve the QP of the last solve() again, from a cold start, with one attempt of ProxQP and ten
  /// times the tolerance. The residual check uses the increased tolerance too.
  void solve_cold(const Dynamics& dynamics, const QpTerms& terms, Solution& out) noexcept;

  void reset() noexcept;

  const QpProblem& problem() const noexcept;  ///< the QP in the selected form, without slacks
  const ElasticSolver& elastic() const noexcept;
  /// The QP that was solved last: problem(), or the elastic QP with its slacks.
  const QpProblem& solved_problem() const noexcept;

 private:
  ElasticSolver& elastic() noexcept;
  void store_result(const QpResult& result, const Dynamics& dynamics, const QpTerms& terms,
                    Solution& out) noexcept;
  void write_solution(const Dynamics& dynamics, const JointLimits& limits, Solution& out) noexcept;

  Robot robot_;
  WholeBodyOptions options_;
  JointTable joints_;
  QpUnits units_;
  FormSelector selector_;
  QpForm form_ = QpForm::kGeneral;
  CondensedQp condensed_;
  GeneralQp general_;
  ElasticSolver condensed_solver_, general_solver_;
  Eigen::VectorXd penalty_, accelerations_, torques_;
  double curvature_ = 1.0, tolerance_ = 0.0;  // values of the last QP
  Vector12 forces_ = Vector12::Zero();
};

}  // namespace surefoot
