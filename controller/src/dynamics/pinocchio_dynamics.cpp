// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/pinocchio_dynamics.hpp"

#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

namespace surefoot {

// The condensed form requires that the entries of each leg are adjacent in the mass matrix, and
// that there are no joints outside the legs.
bool has_three_joint_legs(const Robot& robot) noexcept {
  const auto& model = robot.model();
  if (model.nv != 6 + kMotors || model.nq != 7 + kMotors) return false;
  for (int leg = 0; leg < kLegs; ++leg) {
    pinocchio::JointIndex parent = 1;
    for (int k = 0; k < kLegJoints; ++k) {
      const auto joint = model.getJointId(robot.config().joint_names[3 * leg + k]);
      if (model.parents[joint] != parent) return false;
      if (robot.motor_to_v()[3 * leg + k] != robot.motor_to_v()[3 * leg] + k) return false;
      parent = joint;
    }
  }
  return true;
}

bool has_standard_gravity(const Robot& robot) noexcept {
  const Vector3 gravity = robot.model().gravity.linear();
  // [m/s^2] Numerical: accepts a rounded 9.81.
  return (gravity + kGravity * Vector3::UnitZ()).norm() <= 1e-6;
}

struct PinocchioDynamics::Pinocchio {
  explicit Pinocchio(const pinocchio::Model& m) : model(m), data(m) {}
  const pinocchio::Model& model;  // owned by robot_
  pinocchio::Data data;
};

PinocchioDynamics::PinocchioDynamics(const Robot& robot)
    : pinocchio_(std::make_unique<Pinocchio>(robot.model())), robot_(robot) {}

PinocchioDynamics::~PinocchioDynamics() = default;

void PinocchioDynamics::update(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                               const Vector3& ground_normal, DynamicsTerms& out) noexcept {
  auto& [model, data] = *pinocchio_;
  // crba() computes the mass matrix, the world Jacobian and the placements. nonLinearEffects()
  // computes the velocities, the drifts and h.
  pinocchio::crba(model, data, q, pinocchio::Convention::WORLD);
  pinocchio::nonLinearEffects(model, data, q, v);

  out.R_world_base = data.oMi[1].rotation();
  out.p_world_base = data.oMi[1].translation();
  out.v_base = v.head<3>();
  out.w_base = v.segment<3>(3);
  out.v_world_base = out.R_world_base * out.v_base;
  out.M_base = data.M.topLeftCorner<6, 6>().selfadjointView<Eigen::Upper>();
  out.h_base = data.nle.head<6>();
  update_com(v, out);
  for (int leg = 0; leg < kLegs; ++leg) update_leg(leg, ground_normal, out.legs[leg]);
}

void PinocchioDynamics::update_com(const Eigen::VectorXd& v, DynamicsTerms& out) noexcept {
  const auto& data = pinocchio_->data;
  out.p_world_com = data.oYcrb[1].lever();
  out.I_world_com = data.oYcrb[1].inertia().matrix();
  // The first six rows of M v are the momentum about the base origin, in base axes.
  Vector6 momentum = out.M_base * v.head<6>();
  momentum.noalias() += data.M.topRows<6>().rightCols(v.size() - 6) * v.tail(v.size() - 6);
  const Vector3 linear = out.R_world_base * momentum.head<3>();
  out.v_world_com = linear / robot_.mass();
  out.L_world_com =
      out.R_world_base * momentum.tail<3>() - (out.p_world_com - out.p_world_base).cross(linear);
}

void PinocchioDynamics::update_leg(int leg, const Vector3& ground_normal,
                                   LegDynamics& out) noexcept {
  const auto& [model, data] = *pinocchio_;
  const auto& frame = model.frames[robot_.foot_frame_ids()[leg]];
  const auto& placement = data.oMi[frame.parentJoint];
  const int* column = &robot_.motor_to_v()[3 * leg];

  // Contact point and its Jacobian, from the spatial Jacobian about the world origin O: v_p = v_O +
  // w x p.
  const Vector3 p_centre = placement.act(frame.placement.translation());
  const Vector3 lever = robot_.config().foot_radius * ground_normal;
  out.p_world_contact = p_centre - lever;
  const auto J_base = data.J.middleCols<6>(0);
  const Matrix3 p_cross = skew(out.p_world_contact);
  out.J_base = J_base.topRows<3>() - p_cross * J_base.bottomRows<3>();
  for (int k = 0; k < kLegJoints; ++k) {
    const auto J = data.J.col(column[k]);
    out.J_leg.col(k) = J.head<3>() - out.p_world_contact.cross(J.tail<3>());
    out.joint_axes_world.col(k) = J.tail<3>();
  }

  // Drift: classical acceleration of the foot centre at zero generalised acceleration, plus the
  // rolling term. Pinocchio's a_gf includes -gravity; adding gravity removes it.
  const auto& twist = data.v[frame.parentJoint];
  const auto& acceleration = data.a_gf[frame.parentJoint];
  const Vector3 w = twist.angular();
  const Vector3 r = frame.placement.translation();
  out.w_world_shank = placement.rotation() * w;
  out.v_world_contact =
      placement.rotation() * (twist.linear() + w.cross(r)) + lever.cross(placement.rotation() * w);
  const Vector3 a_centre = acceleration.linear() + acceleration.angular().cross(r) +
                           w.cross(twist.linear() + w.cross(r));
  out.drift = placement.rotation() * a_centre + model.gravity.linear() +
              lever.cross(placement.rotation() * acceleration.angular());

  for (int k = 0; k < kLegJoints; ++k) out.h_leg[k] = data.nle[column[k]];
  // In a robot with further joints, the joints of a leg may not be adjacent in v. Only the upper
  // triangle of data.M is valid.
  for (int k = 0; k < kLegJoints; ++k) {
    out.M_base_leg.col(k) = data.M.col(column[k]).head<6>();
    for (int j = 0; j < kLegJoints; ++j) {
      const auto [first, second] = std::minmax(column[j], column[k]);
      out.M_leg(j, k) = data.M(first, second);
    }
  }
  // The first column of J_leg is (hip axis) x (vector from the hip axis to the contact point). Its
  // component along the thigh axis is the depth of the contact point below the hip axis; det(J_leg)
  // is proportional to this depth.
  out.depth = out.J_leg.col(0).dot(out.joint_axes_world.col(1));
}

void PinocchioDynamics::write_full(const DynamicsTerms& terms, FullDynamics& out) const noexcept {
  const auto& [model, data] = *pinocchio_;
  out.M.triangularView<Eigen::Upper>() = data.M.triangularView<Eigen::Upper>();
  out.M.triangularView<Eigen::StrictlyLower>() =
      out.M.transpose().triangularView<Eigen::StrictlyLower>();
  out.h = data.nle;
  out.J.setZero();
  // Pinocchio's Jacobian belongs to the frame of update(); shift() may have moved the points since
  // then.
  const Vector3 shift = terms.p_world_base - data.oMi[1].translation();
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto calf = model.frames[robot_.foot_frame_ids()[leg]].parentJoint;
    const Vector3 p = terms.legs[leg].p_world_contact - shift;
    for (const auto joint : model.supports[calf]) {
      for (int k = 0; k < model.nvs[joint]; ++k) {
        const int column = model.idx_vs[joint] + k;
        const auto J = data.J.col(column);
        out.J.block<3, 1>(3 * leg, column) = J.head<3>() - p.cross(J.tail<3>());
      }
    }
  }
}

}  // namespace surefoot
