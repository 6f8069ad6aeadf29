// SPDX-License-Identifier: BSD-3-Clause
#include "wbc/qp_units.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "dynamics/standing_pose.hpp"
#include "surefoot/error.hpp"
#include "wbc/condensation.hpp"

namespace surefoot {

namespace {

// Smallest determinant of a leg's Jacobian, as a share of its value in the standing pose. With a
// smaller determinant the knee is nearly straight or the foot is near hip height, and the joint
// accelerations become large. Chosen: at this share they are about ten times those of the standing
// pose.
// If larger: poses that BodyReference allows would be excluded.
constexpr double kMinDeterminantShare = 0.1;

// Return the row norms of the matrix that maps contact forces to the angular acceleration of the
// base. If the condensed form is valid, the feet are fixed; otherwise the joints are locked.
Vector3 angular_row_lengths(const Dynamics& dynamics) {
  Eigen::Matrix<double, 3, 12> rows;
  Condensed condensed;
  if (dynamics.condensable() &&
      condense(dynamics, FeetMatrix::Zero(), Vector6::Zero(), 0.0, condensed)) {
    rows = condensed.B.bottomRows<3>();
  } else {
    const Matrix3 inverse = dynamics.I_world_com().inverse();
    for (int leg = 0; leg < kLegs; ++leg) {
      const Vector3 arm = dynamics.legs()[leg].p_world_contact - dynamics.p_world_com();
      rows.middleCols<3>(3 * leg) = inverse * skew(arm);
    }
  }
  return rows.rowwise().norm();
}

}  // namespace

// A determinant below 1e-9 m^3 can only be a rounding error: in the standing pose the determinant
// is about the cube of a link length.
QpUnits::QpUnits(const Robot& robot) {
  const Dynamics dynamics = standing_dynamics(robot);
  double determinant = std::numeric_limits<double>::infinity();
  double depth = 0.0, arm_squared = 0.0;
  for (const LegDynamics& leg : dynamics.legs()) {
    determinant = std::min(determinant, std::abs(leg.J_leg.determinant()));
    depth += leg.depth / kLegs;
    arm_squared += (leg.p_world_contact - dynamics.p_world_com()).squaredNorm() / kLegs;
  }
  if (!(determinant > 1e-9 && depth > 0.0)) {
    throw Error("robot '" + robot.config().name +
                "': a leg is singular in the standing pose; expected every foot well below its hip "
                "and no straight knee");
  }
  force = robot.mass() * kGravity / kLegs;
  length = depth;
  linear = kGravity;
  angular = kGravity / length;
  scale_com = robot.mass() / std::sqrt(double(kLegs)) / force;
  scale_base = scale_com;
  scale_angular = std::sqrt(3.0) / angular_row_lengths(dynamics).norm() / force;
  scale_momentum = 1.0 / std::sqrt(2.0 * kLegs * arm_squared / 3.0) / force;
  smallest_determinant = kMinDeterminantShare * determinant;
}

}  // namespace surefoot
