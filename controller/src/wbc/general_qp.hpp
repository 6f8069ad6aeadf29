// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "surefoot/qp_problem.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/qp_terms.hpp"

namespace surefoot {

/// The program on accelerations and contact forces, x = [a / unit, f / unit]: for any pose and any
/// further joints. The same tasks and limits as CondensedQp, and the same answer where both
/// hold.
///   equalities: the base's six equations of motion; the feet's accelerations
///   torques:    eliminated, tau = M_j a + h_j - J_j' f, rows of the inequalities
/// The cost holds a multiple of the squared equality rows too: it is zero wherever they hold, so it
/// moves nothing, and makes H positive definite. Real-time: build() and read_solution() yes.
class GeneralQp {
 public:
  GeneralQp(int nv, const JointTable& joints, const QpUnits& units);

  void build(const Dynamics& dynamics, const QpTerms& terms) noexcept;

  const QpProblem& problem() const noexcept { return problem_; }
  double cost_scale() const noexcept { return cost_scale_; }
  /// Of the cost, that is not of the user's own tasks: 0 .. 1.
  double built_in_share() const noexcept { return built_in_share_; }

  /// As CondensedQp::read_solution().
  void read_solution(const Eigen::VectorXd& x, Vector12& forces, Eigen::VectorXd& accelerations,
                     Eigen::VectorXd& torques) const noexcept;

 private:
  void write_equalities(const Dynamics& dynamics, const QpTerms& terms) noexcept;
  void write_joint_rows(const QpTerms& terms) noexcept;
  void write_cost(const Dynamics& dynamics, const QpTerms& terms) noexcept;
  void add_body(const BodyRows& rows) noexcept;
  void add_row(double weight, double b) noexcept;
  void add_soft_foot(const Dynamics& dynamics, const QpTerms& terms, int leg) noexcept;

  int nv_;
  JointTable joints_;
  QpUnits units_;
  QpLayout layout_;
  FullDynamics full_;
  Eigen::VectorXd unit_;  // of each variable
  Eigen::VectorXd row_;   // one row of the cost, in units
  QpProblem problem_;
  double cost_scale_ = 1.0;
  double built_in_share_ = 1.0;
};

}  // namespace surefoot
