// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/quadruped_dynamics.hpp"

#include <pinocchio/multibody.hpp>

#include "dynamics/pinocchio_dynamics.hpp"

namespace surefoot {

namespace code = leg_code;

bool QuadrupedDynamics::fits(const Robot& robot) noexcept {
  const auto& model = robot.model();
  // Numerical: without rotation in the URDF, R is the identity up to rounding.
  const auto unrotated = [](const Matrix3& R) { return R.isIdentity(1e-12); };
  if (!has_three_joint_legs(robot) || !model.jointPlacements[1].isIdentity(1e-12) ||
      !model.armature.head<6>().isZero(0.0)) {
    return false;
  }
  const std::string joint_types[] = {"JointModelRX", "JointModelRY", "JointModelRY"};
  for (int motor = 0; motor < kMotors; ++motor) {
    const auto joint = model.getJointId(robot.config().joint_names[motor]);
    if (model.joints[joint].shortname() != joint_types[motor % 3]) return false;
    if (!unrotated(model.jointPlacements[joint].rotation())) return false;
  }
  return true;
}

QuadrupedDynamics::QuadrupedDynamics(const Robot& robot)
    : legs_(robot), mass_(robot.mass()), gravity_(robot.model().gravity.linear()) {
  const auto& body = robot.model().inertias[1];
  base_mass_ = body.mass();
  base_mass_lever_ = body.mass() * body.lever();
  base_inertia_ = body.matrix().bottomRightCorner<3, 3>();
}

void QuadrupedDynamics::update(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                               const Vector3& ground_normal, DynamicsTerms& out) noexcept {
  out.R_world_base = Eigen::Map<const Quaternion>(q.data() + 3).toRotationMatrix();
  out.p_world_base = q.head<3>();
  out.v_base = v.head<3>();
  out.w_base = v.segment<3>(3);
  out.v_world_base = out.R_world_base * out.v_base;
  const Vector3 g_base = out.R_world_base.transpose() * gravity_;
  legs_.evaluate(q, v, out, g_base, ground_normal);
  assemble_base(g_base, out);
  for (int leg = 0; leg < kLegs; ++leg) legs_.read_leg(leg, out);
}

// Compute the terms of the whole robot. Inertia, momentum and h are sums over the base body and the
// four legs, taken about the base origin in base axes.
void QuadrupedDynamics::assemble_base(const Vector3& g, DynamicsTerms& out) const noexcept {
  double sums[code::kShared];
  legs_.sum_over_legs(sums);
  const auto vector = [&sums](int i) { return Vector3(sums[i], sums[i + 1], sums[i + 2]); };

  const Vector3 mass_lever = base_mass_lever_ + vector(code::kMassLever);
  Matrix3 inertia;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i <= j; ++i) {
      const double entry = base_inertia_(i, j) + sums[code::kInertia + j * (j + 1) / 2 + i];
      inertia(i, j) = inertia(j, i) = entry;
    }
  }
  const Matrix3 cross = skew(mass_lever);
  out.M_base.topLeftCorner<3, 3>() = mass_ * Matrix3::Identity();
  out.M_base.topRightCorner<3, 3>() = -cross;
  out.M_base.bottomLeftCorner<3, 3>() = cross;
  out.M_base.bottomRightCorner<3, 3>() = inertia;

  // Newton-Euler equation of the base body, f = I a + v x* I v (Featherstone 2008, chapter 2).
  // Gravity enters as an upward acceleration.
  const Vector3 &v = out.v_base, &w = out.w_base;
  const Vector3 linear = base_mass_ * v + w.cross(base_mass_lever_);
  const Vector3 angular = base_mass_lever_.cross(v) + base_inertia_ * w;
  out.h_base.head<3>() = vector(code::kHBase) + w.cross(linear) - base_mass_ * g;
  out.h_base.tail<3>() =
      vector(code::kHBase + 3) + w.cross(angular) + v.cross(linear) - base_mass_lever_.cross(g);

  const Vector3 p_base_com = mass_lever / mass_;
  const Matrix3 I_base_com = inertia + skew(p_base_com) * cross;
  const Vector3 p = mass_ * v + w.cross(mass_lever) + vector(code::kMomentum);
  const Vector3 L = mass_lever.cross(v) + inertia * w + vector(code::kMomentum + 3);
  const Matrix3& R = out.R_world_base;
  out.I_world_com = R * I_base_com * R.transpose();
  out.p_world_com = out.p_world_base + R * p_base_com;
  out.v_world_com = R * p / mass_;
  out.L_world_com = R * (L - p_base_com.cross(p));
}

}  // namespace surefoot
