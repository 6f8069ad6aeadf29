// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "surefoot/qp_problem.hpp"
#include "wbc/condensation.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/qp_terms.hpp"

namespace surefoot {

/// The program on the contact forces alone, 12 variables in units of a quarter of the weight.
///
/// f = 0 always satisfies its hard rows, and its elastic rows give way: feasible by construction.
/// Real-time: build() and read_solution() yes.
class CondensedQp {
 public:
  CondensedQp(const JointTable& joints, const QpUnits& units);

  /// Write the program; terms.has_condensed must be true.
  void build(const QpTerms& terms) noexcept;

  const QpProblem& problem() const noexcept { return problem_; }
  /// Factor that brought the cost to trace(H) = n; prices of slacks go with it.
  double cost_scale() const noexcept { return cost_scale_; }
  /// Of the cost, that is not of the user's own tasks: 0 .. 1.
  double built_in_share() const noexcept { return built_in_share_; }

  /// Turn an answer into forces [N], accelerations (Pinocchio's order) and torques (table's order).
  void read_solution(const Eigen::VectorXd& x, Vector12& forces, Eigen::VectorXd& accelerations,
                     Eigen::VectorXd& torques) const noexcept;

 private:
  void write_cost(const QpTerms& terms) noexcept;
  void add_body(const BodyRows& rows) noexcept;
  void add_posture(const QpTerms& terms) noexcept;
  void add_custom(const TaskRows& rows, const Eigen::VectorXd& wanted) noexcept;
  void write_joint_rows(const QpTerms& terms) noexcept;

  QpUnits units_;
  QpLayout layout_;
  Condensed condensed_;
  Matrix12 joint_from_force_;  // leg accelerations = this f + joint_bias_, motor order
  Vector12 joint_bias_;
  Vector12 tau_max_;
  std::array<int, kMotors> motor_to_v_;
  QpProblem problem_;
  double cost_scale_ = 1.0;
  double built_in_share_ = 1.0;
};

}  // namespace surefoot
