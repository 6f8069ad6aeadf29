// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/general_qp.hpp"

#include "dynamics/dynamics.hpp"
#include "wbc/force_rows.hpp"
#include "wbc/qp_units.hpp"

namespace surefoot {

namespace {
constexpr int kForces = QpLayout::kForces;
constexpr int kEqualities = 6 + kForces;
// The squared residuals of the equality rows are added to the cost with this weight, so that H is
// positive definite. The residuals are zero at the solution, so any positive weight gives the same
// solution. Chosen: 1, the size of the other rows.
constexpr double kEqualityWeight = 1.0;
}  // namespace

GeneralQp::GeneralQp(int nv, const JointTable& joints, const QpUnits& units)
    : nv_(nv),
      joints_(joints),
      units_(units),
      layout_(static_cast<int>(joints.size())),
      full_(nv),
      unit_(Eigen::VectorXd::Constant(nv + kForces, units.angular)),
      row_(Eigen::VectorXd::Zero(nv + kForces)),
      problem_(nv + kForces, kEqualities, layout_.rows()) {
  unit_.head<3>().setConstant(units.linear);
  unit_.tail<kForces>().setConstant(units.force);
}

void GeneralQp::build(const Dynamics& dynamics, const QpTerms& terms) noexcept {
  dynamics.write_full(full_);
  full_.h.head<6>() -= terms.external_wrench;
  write_equalities(dynamics, terms);
  write_force_rows(terms, nv_, units_.force, problem_);
  write_joint_rows(terms);
  write_cost(dynamics, terms);
}

void GeneralQp::write_equalities(const Dynamics& dynamics, const QpTerms& terms) noexcept {
  auto& A = problem_.A;
  auto& b = problem_.b;
  A.leftCols(nv_).topRows<6>() = full_.M.topRows<6>();
  A.rightCols<kForces>().topRows<6>() = -full_.J.leftCols<6>().transpose();
  b.head<6>() = -full_.h.head<6>();
  A.bottomLeftCorner(kForces, nv_) = full_.J;
  for (int leg = 0; leg < kLegs; ++leg) {
    b.segment<3>(6 + 3 * leg) = terms.feet_acceleration.col(leg) - dynamics.legs()[leg].drift;
  }
  A.array().rowwise() *= unit_.transpose().array();
  const double moment = units_.force * units_.length;
  A.topRows<3>() /= units_.force;
  b.head<3>() /= units_.force;
  A.middleRows<3>(3) /= moment;
  b.segment<3>(3) /= moment;
  A.bottomRows<kForces>() /= units_.linear;
  b.tail<kForces>() /= units_.linear;
  for (int leg = 0; leg < kLegs; ++leg) {
    if (terms.foot_softness[leg] == 0.0) continue;
    A.middleRows<3>(6 + 3 * leg).setZero();
    b.segment<3>(6 + 3 * leg).setZero();
  }
}

void GeneralQp::write_joint_rows(const QpTerms& terms) noexcept {
  const JointLimits& limits = terms.limits;
  auto& [H, g, A, b, C, l, u] = problem_;
  for (int k = 0; k < layout_.joints; ++k) {
    const int v = joints_[k].v;
    const double inverse = 1.0 / joints_[k].tau_max;
    const int torque = layout_.torque() + k;
    C.row(torque).head(nv_) = inverse * full_.M.row(v).cwiseProduct(unit_.head(nv_).transpose());
    C.row(torque).tail<kForces>() = (-inverse * units_.force) * full_.J.col(v).transpose();
    l[torque] = inverse * (limits.tau_lower[k] - full_.h[v]);
    u[torque] = inverse * (limits.tau_upper[k] - full_.h[v]);
    const int acceleration = layout_.acceleration() + k;
    C(acceleration, v) = 1.0;
    l[acceleration] = (limits.a_lower[k] - limits.a_widening[k]) / units_.angular;
    u[acceleration] = (limits.a_upper[k] + limits.a_widening[k]) / units_.angular;
  }
}

void GeneralQp::write_cost(const Dynamics& dynamics, const QpTerms& terms) noexcept {
  auto& [H, g, A, b, C, l, u] = problem_;
  H.noalias() = kEqualityWeight * A.transpose() * A;
  g.noalias() = -kEqualityWeight * A.transpose() * b;
  H.diagonal().tail<kForces>().array() += terms.weight_force;
  g.tail<kForces>() -= (terms.weight_force / units_.force) * terms.forces;
  for (int k = 0; k < terms.body_tasks; ++k) add_body(terms.body[k]);
  for (int leg = 0; leg < kLegs; ++leg) {
    if (terms.foot_softness[leg] > 0.0) add_soft_foot(dynamics, terms, leg);
  }
  for (int k = 0; terms.has_posture && k < layout_.joints; ++k) {
    const double weight = terms.posture_weight[k];
    H(joints_[k].v, joints_[k].v) += weight;
    g[joints_[k].v] -= weight * terms.posture[k] / units_.angular;
  }
  const double built_in = H.trace();
  for (const CustomTask& custom : terms.custom) {
    const TaskRows& rows = custom.rows;
    for (Eigen::Index k = 0; k < rows.b.size(); ++k) {
      row_.head(nv_) = rows.A_a.row(k);
      row_.tail<kForces>() = rows.A_f.row(k);
      add_row(rows.weight[k], custom.b[k]);
    }
  }
  cost_scale_ = static_cast<double>(g.size()) / H.trace();
  built_in_share_ = built_in / H.trace();
  H *= cost_scale_;
  g *= cost_scale_;
}

void GeneralQp::add_body(const BodyRows& rows) noexcept {
  for (int k = 0; k < 3; ++k) {
    row_.setZero();
    row_.head<6>() = rows.scale * rows.A_base.row(k);
    row_.tail<kForces>() = rows.scale * rows.A_force.row(k);
    add_row(rows.weight[k], rows.scale * rows.b[k]);
  }
}

// Add the foot acceleration as a task, in units of g. The foot then gets only the acceleration that
// its leg can still produce.
void GeneralQp::add_soft_foot(const Dynamics& dynamics, const QpTerms& terms, int leg) noexcept {
  const double scale = 1.0 / units_.linear;
  for (int k = 0; k < 3; ++k) {
    row_.setZero();
    row_.head(nv_) = scale * full_.J.row(3 * leg + k);
    const double desired = terms.feet_acceleration(k, leg) - dynamics.legs()[leg].drift[k];
    add_row(terms.weight_foot_soft[leg], scale * desired);
  }
}

void GeneralQp::add_row(double weight, double b) noexcept {
  row_.array() *= unit_.array();
  problem_.H.noalias() += weight * row_ * row_.transpose();
  problem_.g.noalias() -= (weight * b) * row_;
}

void GeneralQp::read_solution(const Eigen::VectorXd& x, Vector12& forces,
                              Eigen::VectorXd& accelerations,
                              Eigen::VectorXd& torques) const noexcept {
  forces = units_.force * x.tail<kForces>();
  accelerations = x.head(nv_).cwiseProduct(unit_.head(nv_));
  for (int k = 0; k < layout_.joints; ++k) {
    const int v = joints_[k].v;
    torques[k] = full_.M.row(v).dot(accelerations) + full_.h[v] - full_.J.col(v).dot(forces);
  }
}

}  // namespace surefoot
