// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "surefoot/qp_problem.hpp"
#include "wbc/condensation.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/qp_terms.hpp"
#include "wbc/qp_units.hpp"

namespace surefoot {

/// The QP in condensed form. Its 12 variables are the contact forces, in units of a quarter of the
/// robot's weight.
///
/// condense() eliminates accelerations and torques with the equations of motion:
///   a_b = B f + c,   a_l = W a_b + w,   tau = T f + t0
/// so every task and every limit becomes rows in f. The QP has no equalities. Its hard constraints
/// (friction and normal force) allow f = 0, and all other constraints are elastic. So the QP is
/// always feasible. This form is valid only for a robot with four legs of three joints each and no
/// other joints, and only while no leg is singular. Real-time: build() and read_solution() yes.
class CondensedQp {
 public:
  CondensedQp(const JointTable& joints, const QpUnits& units);

  /// Write the QP. terms.has_condensed must be true.
  void build(const QpTerms& terms) noexcept;

  const QpProblem& problem() const noexcept { return problem_; }
  /// Factor that scales the cost to trace(H) = n. Scale penalties by the same factor.
  double cost_scale() const noexcept { return cost_scale_; }
  /// Share of trace(H) that does not come from user tasks, 0 .. 1.
  double built_in_share() const noexcept { return built_in_share_; }

  /// Convert a solution x to contact forces [N], accelerations (Pinocchio's order) and joint
  /// torques [N.m] (order of the joint table).
  void read_solution(const Eigen::VectorXd& x, Vector12& forces, Eigen::VectorXd& accelerations,
                     Eigen::VectorXd& torques) const noexcept;

 private:
  void write_cost(const QpTerms& terms) noexcept;
  void add_body(const BodyRows& rows) noexcept;
  void add_posture(const QpTerms& terms) noexcept;
  void add_custom(const TaskRows& rows, const Eigen::VectorXd& desired) noexcept;
  void write_joint_rows(const QpTerms& terms) noexcept;

  QpUnits units_;
  QpLayout layout_;
  Condensed condensed_;
  Matrix12 joint_from_force_;  // a_l = joint_from_force_ f + joint_bias_, motor order
  Vector12 joint_bias_;
  Vector12 tau_max_;
  std::array<int, kMotors> motor_to_v_;
  QpProblem problem_;
  double cost_scale_ = 1.0;
  double built_in_share_ = 1.0;
};

}  // namespace surefoot
