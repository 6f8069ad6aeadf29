// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/condensed_qp.hpp"

#include "wbc/force_rows.hpp"
#include "wbc/qp_units.hpp"

namespace surefoot {

namespace {
constexpr int kForces = QpLayout::kForces;
}

CondensedQp::CondensedQp(const JointTable& joints, const QpUnits& units)
    : units_(units), layout_(kMotors), problem_(kForces, 0, layout_.rows()) {
  for (int i = 0; i < kMotors; ++i) {
    tau_max_[i] = joints[i].tau_max;
    motor_to_v_[i] = joints[i].v;
  }
}

void CondensedQp::build(const QpTerms& terms) noexcept {
  condensed_ = terms.condensed;
  joint_from_force_.noalias() = condensed_.W * condensed_.B;
  joint_bias_ = condensed_.leg_accelerations(condensed_.c);
  write_cost(terms);
  write_force_rows(terms, 0, units_.force, problem_);
  write_joint_rows(terms);
}

void CondensedQp::write_cost(const QpTerms& terms) noexcept {
  problem_.H.setZero();
  problem_.H.diagonal().setConstant(terms.weight_force);
  problem_.g = (-terms.weight_force / units_.force) * terms.forces;
  for (int k = 0; k < terms.body_tasks; ++k) add_body(terms.body[k]);
  if (terms.has_posture) add_posture(terms);
  const double built_in = problem_.H.trace();
  for (const CustomTask& custom : terms.custom) add_custom(custom.rows, custom.b);
  cost_scale_ = kForces / problem_.H.trace();
  built_in_share_ = built_in / problem_.H.trace();
  problem_.H *= cost_scale_;
  problem_.g *= cost_scale_;
}

void CondensedQp::add_body(const BodyRows& rows) noexcept {
  // f = units_.force * x, so the rows are multiplied by units_.force. rows.scale brings the rows to
  // length one in the standing pose.
  Matrix3x12 A = rows.A_force;
  A.noalias() += rows.A_base * condensed_.B;
  A *= rows.scale * units_.force;
  const Vector3 b = rows.scale * (rows.b - rows.A_base * condensed_.c);
  problem_.H.noalias() += A.transpose() * rows.weight.asDiagonal() * A;
  problem_.g.noalias() -= A.transpose() * rows.weight.cwiseProduct(b);
}

void CondensedQp::add_posture(const QpTerms& terms) noexcept {
  const Matrix12 A = (units_.force / units_.angular) * joint_from_force_;
  const Vector12 b = (terms.posture - joint_bias_) / units_.angular;
  const Vector12 weight = terms.posture_weight;  // fixed size: the product allocates no memory
  problem_.H.noalias() += A.transpose() * weight.asDiagonal() * A;
  problem_.g.noalias() -= A.transpose() * weight.cwiseProduct(b);
}

void CondensedQp::add_custom(const TaskRows& rows, const Eigen::VectorXd& desired) noexcept {
  for (Eigen::Index k = 0; k < desired.size(); ++k) {
    Eigen::Matrix<double, 1, 6> base = rows.A_a.row(k).head<6>();
    double b = desired[k];
    for (int i = 0; i < kMotors; ++i) {
      const double joint = rows.A_a(k, motor_to_v_[i]);
      base.noalias() += joint * condensed_.W.row(i);
      b -= joint * condensed_.w[i];
    }
    b -= base.dot(condensed_.c);
    Eigen::Matrix<double, 1, kForces> A = rows.A_f.row(k);
    A.noalias() += base * condensed_.B;
    A *= units_.force;
    problem_.H.noalias() += rows.weight[k] * A.transpose() * A;
    problem_.g.noalias() -= (rows.weight[k] * b) * A.transpose();
  }
}

void CondensedQp::write_joint_rows(const QpTerms& terms) noexcept {
  const JointLimits& limits = terms.limits;
  const Vector12 inverse = tau_max_.cwiseInverse();
  const int torque = layout_.torque();
  problem_.C.block<kMotors, kForces>(torque, 0) =
      (units_.force * inverse).asDiagonal() * condensed_.T;
  problem_.l.segment<kMotors>(torque) = (limits.tau_lower - condensed_.t0).cwiseProduct(inverse);
  problem_.u.segment<kMotors>(torque) = (limits.tau_upper - condensed_.t0).cwiseProduct(inverse);

  const double unit = 1.0 / units_.angular;
  const int acceleration = layout_.acceleration();
  problem_.C.block<kMotors, kForces>(acceleration, 0) = (unit * units_.force) * joint_from_force_;
  problem_.l.segment<kMotors>(acceleration) =
      unit * (limits.a_lower - limits.a_widening - joint_bias_);
  problem_.u.segment<kMotors>(acceleration) =
      unit * (limits.a_upper + limits.a_widening - joint_bias_);
}

void CondensedQp::read_solution(const Eigen::VectorXd& x, Vector12& forces,
                                Eigen::VectorXd& accelerations,
                                Eigen::VectorXd& torques) const noexcept {
  forces = units_.force * x;
  const Vector6 a_base = condensed_.B * forces + condensed_.c;
  const Vector12 a_legs = condensed_.leg_accelerations(a_base);
  accelerations.head<6>() = a_base;
  for (int i = 0; i < kMotors; ++i) accelerations[motor_to_v_[i]] = a_legs[i];
  torques.noalias() = condensed_.T * forces;
  torques += condensed_.t0;
}

}  // namespace surefoot
