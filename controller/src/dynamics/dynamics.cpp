// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/dynamics.hpp"

#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include "surefoot/error.hpp"

namespace surefoot {

struct Dynamics::Pinocchio {
  explicit Pinocchio(const pinocchio::Model& m) : model(m), data(m) {}
  const pinocchio::Model& model;  // lives in the Robot that Dynamics keeps
  pinocchio::Data data;
};

Dynamics::Dynamics(const Robot& robot)
    : pinocchio_(std::make_unique<Pinocchio>(robot.model())), robot_(robot) {
  if (robot.nv() != 6 + kMotors || robot.nq() != 7 + kMotors) {
    throw Error("robot '" + robot.config().name + "': got nq = " + std::to_string(robot.nq()) +
                ", nv = " + std::to_string(robot.nv()) +
                ", expected 19 and 18: a free base and 12 leg joints; make any others fixed");
  }
  const Vector3 gravity = robot.model().gravity.linear();
  if ((gravity + kGravity * Vector3::UnitZ()).norm() > 1e-6) {
    throw Error("robot '" + robot.config().name + "': the model's gravity is not (0, 0, -9.81)");
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    const int first = robot.motor_to_v()[3 * leg];
    for (int k = 1; k < kLegJoints; ++k) {
      // The leg's blocks are read as contiguous 3x3 pieces of the mass matrix.
      if (robot.motor_to_v()[3 * leg + k] == first + k) continue;
      throw Error(
          "robot '" + robot.config().name + "': joint '" + robot.config().joint_names[3 * leg + k] +
          "' does not follow its leg's previous joint in the model; expected the chain hip, "
          "thigh, calf");
    }
  }
}

Dynamics::~Dynamics() = default;
Dynamics::Dynamics(Dynamics&&) noexcept = default;

void Dynamics::update(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                      const Vector3& ground_normal) noexcept {
  auto& [model, data] = *pinocchio_;
  // One pass each: mass matrix, world Jacobian and placements; then velocities, drifts and bias.
  pinocchio::crba(model, data, q, pinocchio::Convention::WORLD);
  pinocchio::nonLinearEffects(model, data, q, v);

  R_world_base_ = data.oMi[1].rotation();
  w_base_ = v.segment<3>(3);
  M_base_ = data.M.topLeftCorner<6, 6>().selfadjointView<Eigen::Upper>();
  h_base_ = data.nle.head<6>();
  a_base_shift_.setZero();
  update_com(v);
  for (int leg = 0; leg < kLegs; ++leg) update_leg(leg, ground_normal, v);
}

void Dynamics::shift(const Vector3& p_world, const Vector3& v_world) noexcept {
  p_world_com_ += p_world;
  v_world_com_ += v_world;
  a_base_shift_ = -w_base_.cross(R_world_base_.transpose() * v_world);
  for (LegDynamics& leg : legs_) {
    leg.p_world_contact += p_world;
    leg.v_world_contact += v_world;
  }
}

void Dynamics::update_com(const Eigen::VectorXd& v) noexcept {
  const auto& data = pinocchio_->data;
  p_world_com_ = data.oYcrb[1].lever();
  // The first three rows of M are the linear momentum in base axes.
  const Vector3 momentum = data.M.topRows<3>().rightCols(v.size() - 3) * v.tail(v.size() - 3) +
                           M_base_.topLeftCorner<3, 3>() * v.head<3>();
  v_world_com_ = R_world_base_ * momentum / robot_.mass();
}

void Dynamics::update_leg(int leg, const Vector3& ground_normal,
                          const Eigen::VectorXd& v) noexcept {
  const auto& [model, data] = *pinocchio_;
  const auto& frame = model.frames[robot_.foot_frame_ids()[leg]];
  const auto& placement = data.oMi[frame.parentJoint];
  const int first = robot_.motor_to_v()[3 * leg];
  LegDynamics& out = legs_[leg];

  // Contact point and its rows: v_p = v_O + w x p from the spatial Jacobian about the world origin.
  const Vector3 p_centre = placement.act(frame.placement.translation());
  const Vector3 lever = robot_.config().foot_radius * ground_normal;
  out.p_world_contact = p_centre - lever;
  const auto J_base = data.J.middleCols<6>(0);
  const auto J_leg = data.J.middleCols<3>(first);
  const Matrix3 p_cross = skew(out.p_world_contact);
  out.J_base = J_base.topRows<3>() - p_cross * J_base.bottomRows<3>();
  out.J_leg = J_leg.topRows<3>() - p_cross * J_leg.bottomRows<3>();
  out.v_world_contact = out.J_base * v.head<6>() + out.J_leg * v.segment<3>(first);

  // Drift: classical acceleration of the foot centre at zero joint acceleration (a_gf carries
  // -gravity), plus the rolling term.
  const auto& twist = data.v[frame.parentJoint];
  const auto& accel = data.a_gf[frame.parentJoint];
  const Vector3 w = twist.angular();
  const Vector3 r = frame.placement.translation();
  const Vector3 centre =
      accel.linear() + accel.angular().cross(r) + w.cross(twist.linear() + w.cross(r));
  out.drift = placement.rotation() * centre + model.gravity.linear() +
              lever.cross(placement.rotation() * accel.angular());

  out.M_base_leg = data.M.block<6, 3>(0, first);
  out.M_leg = data.M.block<3, 3>(first, first).selfadjointView<Eigen::Upper>();
  out.h_leg = data.nle.segment<3>(first);
}

}  // namespace surefoot
