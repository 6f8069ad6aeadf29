// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/leg_pairs.hpp"

#include <cmath>
#include <pinocchio/multibody.hpp>

namespace surefoot {

namespace code = leg_code;

namespace {

// The code's parameters, in its order, of the joint that a motor drives and the body behind it.
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

// One leg's half of the results, read in the order of Eigen's columns.
struct Half {
  const Pair* results;
  int half;
  double operator[](int i) const { return results[i][half]; }
  template <typename Matrix>
  void read(int first, Matrix& out) const {
    for (int i = 0; i < out.size(); ++i) out.data()[i] = (*this)[first + i];
  }
  // From the upper triangle, column by column.
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

LegPairs::LegPairs(const Robot& robot)
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
    for (int i = 0; i < code::kPacked; ++i) packed_[leg / 2][i][leg % 2] = constants[i];
  }
}

void LegPairs::write_base(const TickDynamics& now, const Vector3& g_base,
                          const Vector3& ground_normal) noexcept {
  const auto write = [this](int first, const Vector3& value) {
    for (int i = 0; i < 3; ++i) base_[first + i] = Pair{value[i], value[i]};
  };
  write(0, now.v_base);
  write(3, now.w_base);
  for (int k = 0; k < 3; ++k) write(6 + 3 * k, now.R_world_base.col(k));
  write(15, g_base);
  write(18, now.R_world_base.transpose() * (foot_radius_ * ground_normal));
}

void LegPairs::write_legs(const Eigen::VectorXd& q, const Eigen::VectorXd& v) noexcept {
  for (int motor = 0; motor < kMotors; ++motor) {
    const int leg = motor / 3, k = motor % 3;
    const double angle = q[motor_to_q_[motor]];
    legs_[leg / 2][2 * k][leg % 2] = std::cos(angle);
    legs_[leg / 2][2 * k + 1][leg % 2] = std::sin(angle);
    legs_[leg / 2][6 + k][leg % 2] = v[motor_to_v_[motor]];
  }
}

void LegPairs::evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& v, const TickDynamics& now,
                        const Vector3& g_base, const Vector3& ground_normal) noexcept {
  write_base(now, g_base, ground_normal);
  write_legs(q, v);
  for (int pair = 0; pair < kPairs; ++pair) {
    code::leg_dynamics(packed_[pair], base_, legs_[pair], results_[pair]);
  }
}

void LegPairs::add_up(double (&sums)[leg_code::kShared]) const noexcept {
  for (int i = 0; i < leg_code::kShared; ++i) {
    const Pair pair = results_[0][i] + results_[1][i];
    sums[i] = pair[0] + pair[1];
  }
}

void LegPairs::read_leg(int leg, TickDynamics& out) const noexcept {
  const Half half{results_[leg / 2], leg % 2};
  LegDynamics& L = out.legs[leg];
  half.read(code::kHLeg, L.h_leg);
  half.read(code::kMBaseLeg, L.M_base_leg);
  half.read_symmetric(code::kMLeg, L.M_leg);
  L.p_world_contact = out.p_world_base + half.vector(code::kPContact);
  half.read(code::kVContact, L.v_world_contact);
  // Hip about x, thigh and calf about the y that the hip has turned.
  const Half joints{legs_[leg / 2], leg % 2};
  L.axes_world.col(0) = out.R_world_base.col(0);
  L.axes_world.col(1) = out.R_world_base * Vector3(0.0, joints[0], joints[1]);
  L.axes_world.col(2) = L.axes_world.col(1);
  const Vector3 dq(joints[6], joints[7], joints[8]);
  L.w_world_shank = out.R_world_base * out.w_base + L.axes_world * dq;
  half.read(code::kDrift, L.drift);
  half.read(code::kJLeg, L.J_leg);
  L.J_base.leftCols<3>() = out.R_world_base;
  for (int i = 0; i < 9; ++i) L.J_base.data()[9 + i] = half[code::kJBaseAngular + i];
  L.depth = half[code::kDepth];
}

}  // namespace surefoot
