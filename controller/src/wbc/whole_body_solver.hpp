// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/whole_body_controller.hpp"
#include "wbc/condensed_qp.hpp"
#include "wbc/elastic_solver.hpp"
#include "wbc/form_selector.hpp"
#include "wbc/general_qp.hpp"

namespace surefoot {

/// Chooses the form, poses the program, solves it and reads the answer. Real-time: yes.
class WholeBodySolver {
 public:
  /// Throws surefoot::Error when the condensed form is asked for and the robot does not fit it.
  WholeBodySolver(const Robot& robot, const WholeBodyOptions& options);

  /// Choose the form; returns how soft each foot's row is, 0 .. 1.
  const Eigen::Vector4d& select_form(const Dynamics& dynamics, const Reference& reference) noexcept;

  /// Solve in that form. On failure only the solution's status and residuals change.
  void solve(const Gains& gains, const Dynamics& dynamics, const QpTerms& terms,
             Solution& out) noexcept;

  /// Solve what solve() posed once more, from nothing, in one attempt, and to the relaxed
  /// tolerance: ten times the program's, checked as strictly as any.
  void solve_cold(const Dynamics& dynamics, const QpTerms& terms, Solution& out) noexcept;

  void reset() noexcept;

  const QpProblem& problem() const noexcept;  ///< of the form in force
  const ElasticSolver& elastic() const noexcept;
  const QpProblem& solved_problem() const noexcept;  ///< the same, with slacks where something gave

 private:
  ElasticSolver& elastic() noexcept;
  void take_result(const QpResult& result, const Dynamics& dynamics, const QpTerms& terms,
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
  double curvature_ = 1.0, tolerance_ = 0.0;  // of the program that was posed last
  Vector12 forces_ = Vector12::Zero();
};

}  // namespace surefoot
