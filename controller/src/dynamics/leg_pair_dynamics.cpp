// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/leg_pair_dynamics.hpp"

#include <cmath>
#include <pinocchio/multibody.hpp>

namespace surefoot {

namespace code = leg_code;

namespace {

// Write the parameters of a motor's joint and of the body that it moves, in the order of the
// generated code.
double* write_joint(const Robot& robot, int motor, double* out) {
  const auto& model = robot.model();
  const auto joint = model.getJointId(robot.config().joint_names[motor]);
  const auto& inertia = model.inertias[joint];
  for (int i = 0; i < 3; ++i) *out++ = model.jointPlacements[joint].translation()[i];
  *out++ = inertia.mass();
  for (int i = 0; i < 3; ++i) *out++ = inertia.lever()[i];
  for (int i = 0; i < 6; ++i) *out++ = inertia.inertia().data()[i];
  *out++ = model.armature[robot.motor_to_v()[motor]];
  return out;
}

// View of the values of one leg in an array of LegPair. Matrices are stored by columns.
struct LegLane {
  const LegPair* results;
  int lane;
  double operator[](int i) const { return results[i][lane]; }
  template <typename Matrix>
  void read(int first, Matrix& out) const {
    for (int i = 0; i < out.size(); ++i) out.data()[i] = (*this)[first + i];
  }
  // Read a symmetric matrix from its upper triangle, stored by columns.
  void read_symmetric(int first, Matrix3& out) const {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i <= j; ++i) out(i, j) = out(j, i) = (*this)[first + j * (j + 1) / 2 + i];
    }
  }
  Vector3 vector(int first) const {
    return {(*this)[first], (*this)[first + 1], (*this)[first + 2]};
  }
};

}  // namespace

LegPairDynamics::LegPairDynamics(const Robot& robot)
    : foot_radius_(robot.config().foot_radius),
      motor_to_q_(robot.motor_to_q()),
      motor_to_v_(robot.motor_to_v()) {
  for (int leg = 0; leg < kLegs; ++leg) {
    double parameters[code::kParameters], constants[code::kPacked];
    double* next = parameters;
    for (int k = 0; k < kLegJoints; ++k) next = write_joint(robot, 3 * leg + k, next);
    const Vector3& foot = robot.model().frames[robot.foot_frame_ids()[leg]].placement.translation();
    for (int i = 0; i < 3; ++i) *next++ = foot[i];
    code::pack_leg(parameters, constants);
    for (int i = 0; i < code::kPacked; ++i) leg_constants_[leg / 2][i][leg % 2] = constants[i];
  }
}

void LegPairDynamics::write_base(const DynamicsTerms& terms, const Vector3& g_base,
                                 const Vector3& ground_normal) noexcept {
  const auto write = [this](int first, const Vector3& value) {
    for (int i = 0; i < 3; ++i) base_inputs_[first + i] = LegPair{value[i], value[i]};
  };
  write(0, terms.v_base);
  write(3, terms.w_base);
  for (int k = 0; k < 3; ++k) write(6 + 3 * k, terms.R_world_base.col(k));
  write(15, g_base);
  write(18, terms.R_world_base.transpose() * (foot_radius_ * ground_normal));
}

void LegPairDynamics::write_legs(const Eigen::VectorXd& q, const Eigen::VectorXd& v) noexcept {
  for (int motor = 0; motor < kMotors; ++motor) {
    const int leg = motor / 3, k = motor % 3;
    const double angle = q[motor_to_q_[motor]];
    leg_inputs_[leg / 2][2 * k][leg % 2] = std::cos(angle);
    leg_inputs_[leg / 2][2 * k + 1][leg % 2] = std::sin(angle);
    leg_inputs_[leg / 2][6 + k][leg % 2] = v[motor_to_v_[motor]];
  }
}

void LegPairDynamics::evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                               const DynamicsTerms& terms, const Vector3& g_base,
                               const Vector3& ground_normal) noexcept {
  write_base(terms, g_base, ground_normal);
  write_legs(q, v);
  for (int pair = 0; pair < kPairs; ++pair) {
    code::leg_dynamics(leg_constants_[pair], base_inputs_, leg_inputs_[pair], results_[pair]);
  }
}

void LegPairDynamics::sum_over_legs(double (&sums)[leg_code::kShared]) const noexcept {
  for (int i = 0; i < leg_code::kShared; ++i) {
    const LegPair pair = results_[0][i] + results_[1][i];
    sums[i] = pair[0] + pair[1];
  }
}

void LegPairDynamics::read_leg(int leg, DynamicsTerms& out) const noexcept {
  const LegLane lane{results_[leg / 2], leg % 2};
  LegDynamics& L = out.legs[leg];
  lane.read(code::kHLeg, L.h_leg);
  lane.read(code::kMBaseLeg, L.M_base_leg);
  lane.read_symmetric(code::kMLeg, L.M_leg);
  L.p_world_contact = out.p_world_base + lane.vector(code::kPContact);
  lane.read(code::kVContact, L.v_world_contact);
  // The hip axis is x; thigh and calf axes are y, rotated by the hip angle.
  const LegLane joints{leg_inputs_[leg / 2], leg % 2};
  L.joint_axes_world.col(0) = out.R_world_base.col(0);
  L.joint_axes_world.col(1) = out.R_world_base * Vector3(0.0, joints[0], joints[1]);
  L.joint_axes_world.col(2) = L.joint_axes_world.col(1);
  const Vector3 dq(joints[6], joints[7], joints[8]);
  L.w_world_shank = out.R_world_base * out.w_base + L.joint_axes_world * dq;
  lane.read(code::kDrift, L.drift);
  lane.read(code::kJLeg, L.J_leg);
  L.J_base.leftCols<3>() = out.R_world_base;
  for (int i = 0; i < 9; ++i) L.J_base.data()[9 + i] = lane[code::kJBaseAngular + i];
  L.depth = lane[code::kDepth];
}

}  // namespace surefoot
