// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/whole_body_program.hpp"

#include <Eigen/LU>
#include <limits>

#include "surefoot/error.hpp"

namespace surefoot {

namespace {

// A leg's Jacobian may shrink to this share of what it is in the standing pose: less is a knee
// nearly straight or a foot near hip height, where accelerations run away.
constexpr double kSmallestShare = 0.1;

Dynamics standing_dynamics(const Robot& robot) {
  Dynamics dynamics(robot);
  dynamics.update(robot.q_standing(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
  return dynamics;
}

double standing_determinant(const Robot& robot) {
  const Dynamics dynamics = standing_dynamics(robot);
  double smallest = std::numeric_limits<double>::infinity();
  for (const LegDynamics& leg : dynamics.legs()) {
    smallest = std::min(smallest, std::abs(leg.J_leg.determinant()));
  }
  return smallest;
}

// Lengths of the angular rows in the standing pose: what "weight 1" is measured in.
Vector3 standing_row_lengths(const Robot& robot) {
  Condensed condensed;
  if (!condense(standing_dynamics(robot), FeetMatrix::Zero(), 1e-9, condensed)) {
    throw Error("robot '" + robot.config().name +
                "': a leg is singular in the standing pose; expected every foot well below its hip "
                "and no straight knee");
  }
  return condensed.B.bottomRows<3>().rowwise().norm();
}

}  // namespace

WholeBodyProgram::WholeBodyProgram(const Robot& robot)
    : tau_max_(robot.config().tau_max),
      force_unit_(robot.mass() * kGravity / kLegs),
      smallest_determinant_(kSmallestShare * standing_determinant(robot)),
      com_scale_(Vector3::Constant(robot.mass() / std::sqrt(double(kLegs)))),
      angular_scale_(standing_row_lengths(robot).cwiseInverse()),
      problem_(kForces, kRows) {
  com_scale_ /= force_unit_;
  angular_scale_ /= force_unit_;
}

void WholeBodyProgram::add_task(const TaskRows& rows, const Vector3& scale) noexcept {
  // In force units: A f = (A * unit) x; scaled so that the row has length one when standing.
  const Eigen::Matrix<double, 3, 12> A = (scale * force_unit_).asDiagonal() * rows.A;
  const Vector3 b = scale.cwiseProduct(rows.b);
  problem_.H.noalias() += A.transpose() * rows.weight.asDiagonal() * A;
  problem_.g.noalias() -= A.transpose() * rows.weight.cwiseProduct(b);
}

void WholeBodyProgram::set_cost(const Gains& gains, const TaskRows& com,
                                const TaskRows& orientation, const Vector12& even) noexcept {
  problem_.H.setZero();
  problem_.H.diagonal().setConstant(gains.weight_force);
  problem_.g = (-gains.weight_force / force_unit_) * even;
  add_task(com, com_scale_);
  add_task(orientation, angular_scale_);
  const double scale = kForces / problem_.H.trace();
  problem_.H *= scale;
  problem_.g *= scale;
}

void WholeBodyProgram::set_friction(const Vector3& normal, double friction,
                                    const Eigen::Vector4d& maximum) noexcept {
  const ConeRows cone = friction_cone(normal, friction);
  for (int leg = 0; leg < kLegs; ++leg) {
    const int row = leg * kFootRows;
    auto C = problem_.C.block<kFootRows, 3>(row, 3 * leg);
    auto l = problem_.l.segment<kFootRows>(row);
    auto u = problem_.u.segment<kFootRows>(row);
    l.setConstant(-kNoBound);
    if (maximum[leg] > 0.0) {
      C << cone, normal.transpose();
      u.setZero();
      l[kFacets] = 0.0;
      u[kFacets] = maximum[leg] / force_unit_;
    } else {
      // No force at all: three rows that say so. All facets of an empty cone would meet in one
      // point, and a solver gropes among their multipliers.
      C.setZero();
      C.topRows<3>().setIdentity();
      l.head<3>().setZero();
      u.setConstant(kNoBound);
      u.head<3>().setZero();
    }
  }
}

void WholeBodyProgram::set_torque_limits(const Condensed& condensed,
                                         const TorqueLimits& limits) noexcept {
  const int row = kLegs * kFootRows;
  const Vector12 inverse = tau_max_.cwiseInverse();
  problem_.C.block<kMotors, kForces>(row, 0) = (force_unit_ * inverse).asDiagonal() * condensed.T;
  const Vector12 lower = (limits.col(0) - condensed.t0).cwiseProduct(inverse);
  const Vector12 upper = (limits.col(1) - condensed.t0).cwiseProduct(inverse);
  problem_.l.segment<kMotors>(row) = lower.cwiseMin(0.0);
  problem_.u.segment<kMotors>(row) = upper.cwiseMax(0.0);
}

}  // namespace surefoot
