// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/dynamics.hpp"

#include "dynamics/joint_friction.hpp"
#include "dynamics/pinocchio_dynamics.hpp"
#include "dynamics/quadruped_dynamics.hpp"
#include "surefoot/error.hpp"
#include "surefoot/stage_clock.hpp"

namespace surefoot {

Dynamics::Dynamics(const Robot& robot, Source source)
    : robot_(robot), condensable_(has_three_joint_legs(robot)) {
  if (!has_standard_gravity(robot)) {
    throw Error("robot '" + robot.config().name +
                "': gravity of the model: got another value, expected (0, 0, -9.81) m/s^2");
  }
  if (source == Source::kAuto && QuadrupedDynamics::fits(robot)) {
    quadruped_ = std::make_unique<QuadrupedDynamics>(robot);
  } else {
    pinocchio_ = std::make_unique<PinocchioDynamics>(robot);
  }
  // depth_sign_ makes the depth of each foot positive in the standing pose.
  update(robot.q_standing(), Eigen::VectorXd::Zero(robot.nv()), Vector3::UnitZ());
  for (int leg = 0; leg < kLegs; ++leg)
    depth_sign_[leg] = terms_.legs[leg].depth < 0.0 ? -1.0 : 1.0;
}

Dynamics::~Dynamics() = default;
Dynamics::Dynamics(Dynamics&&) noexcept = default;

void Dynamics::set_joints(const RobotState& state) noexcept {
  armature_error_ = state.armature_error;
  damping_ = state.joint_damping;
  friction_ = state.joint_friction;
}

void Dynamics::update(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                      const Vector3& ground_normal) noexcept {
  const StageScope stage(Stage::kDynamics);
  if (quadruped_) {
    quadruped_->update(q, v, ground_normal, terms_);
  } else {
    pinocchio_->update(q, v, ground_normal, terms_);
  }
  for (int i = 0; i < kMotors; ++i) {
    const double dq = v[robot_.motor_to_v()[i]];
    friction_torque_[i] = damping_[i] * dq;
    if (friction_[i] > 0.0) friction_torque_[i] += friction_[i] * smooth_sign(dq);
  }
  for (int leg = 0; leg < kLegs; ++leg) {
    terms_.legs[leg].depth *= depth_sign_[leg];
    terms_.legs[leg].M_leg.diagonal() += armature_error_.segment<3>(3 * leg);
    terms_.legs[leg].h_leg += friction_torque_.segment<3>(3 * leg);
  }
  a_base_shift_.setZero();
}

void Dynamics::shift(const Vector3& p_world, const Vector3& v_world) noexcept {
  terms_.p_world_com += p_world;
  terms_.v_world_com += v_world;
  terms_.p_world_base += p_world;
  terms_.v_world_base += v_world;
  a_base_shift_ = -terms_.w_base.cross(terms_.R_world_base.transpose() * v_world);
  for (LegDynamics& leg : terms_.legs) {
    leg.p_world_contact += p_world;
    leg.v_world_contact += v_world;
  }
}

void Dynamics::write_full(FullDynamics& out) const noexcept {
  if (pinocchio_) {
    pinocchio_->write_full(terms_, out);
    for (int i = 0; i < kMotors; ++i) {
      const int v = robot_.motor_to_v()[i];
      out.M(v, v) += armature_error_[i];
      out.h[v] += friction_torque_[i];
    }
    return;
  }
  // Legs are coupled only through the base. All blocks that are not written here have been zero
  // since construction.
  out.M.topLeftCorner<6, 6>() = terms_.M_base;
  out.h.head<6>() = terms_.h_base;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegDynamics& L = terms_.legs[leg];
    const int row = 3 * leg, column = robot_.motor_to_v()[row];
    out.M.block<6, 3>(0, column) = L.M_base_leg;
    out.M.block<3, 6>(column, 0) = L.M_base_leg.transpose();
    out.M.block<3, 3>(column, column) = L.M_leg;
    out.h.segment<3>(column) = L.h_leg;
    out.J.block<3, 6>(row, 0) = L.J_base;
    out.J.block<3, 3>(row, column) = L.J_leg;
  }
}

}  // namespace surefoot
