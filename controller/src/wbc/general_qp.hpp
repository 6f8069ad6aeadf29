// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/joint_table.hpp"
#include "surefoot/qp_problem.hpp"
#include "wbc/qp_layout.hpp"
#include "wbc/qp_terms.hpp"
#include "wbc/qp_units.hpp"

namespace surefoot {

/// The QP in general form, on accelerations and contact forces: x = [a / unit, f / unit]. This form
/// is valid for any pose, singular legs included, and for robots with further joints.
///
///   equalities: the six equations of motion of the base; the foot accelerations
///   torques:    tau = M_j a + h_j - J_j' f, bounded by inequality rows
/// If a leg is nearly singular, its foot acceleration is a task in the cost instead of an equality
/// (FormSelector). The tasks and limits are the same as in CondensedQp. Where both forms are valid,
/// their solutions agree. The cost also contains the squared residuals of the equality rows, so
/// that H is positive definite. This part is zero where the equalities hold, so it does not change
/// the solution. Real-time: build() and read_solution() yes.
class GeneralQp {
 public:
  GeneralQp(int nv, const JointTable& joints, const QpUnits& units);

  /// Write the QP.
  void build(const Dynamics& dynamics, const QpTerms& terms) noexcept;

  const QpProblem& problem() const noexcept { return problem_; }
  /// Factor that scales the cost to trace(H) = n. Scale penalties by the same factor.
  double cost_scale() const noexcept { return cost_scale_; }
  /// Share of trace(H) that does not come from user tasks, 0 .. 1.
  double built_in_share() const noexcept { return built_in_share_; }

  /// Convert a solution x as CondensedQp::read_solution() does.
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
  Eigen::VectorXd unit_;  // unit of each variable: [m/s^2], [rad/s^2] or [N]
  Eigen::VectorXd row_;   // scratch: one row of the cost
  QpProblem problem_;
  double cost_scale_ = 1.0;
  double built_in_share_ = 1.0;
};

}  // namespace surefoot
