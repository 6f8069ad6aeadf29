// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics/stance_kinematics.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <pinocchio/algorithm/center-of-mass.hpp>
#include <pinocchio/algorithm/jacobian.hpp>

namespace surefoot {

namespace {
// Largest number of Newton steps. Chosen: each step doubles the number of correct digits, so more
// steps would find no further solution.
constexpr int kMaxNewtonSteps = 6;
// [m] Foot position error up to which a solution is accepted. Chosen smaller than the resolution of
// the joint encoders, which is 6e-6 m at the foot.
constexpr double kTolerance = 1e-6;
// [rad] Largest change of a joint in one step. Chosen. If larger: a step could bend the knee to the
// other side.
constexpr double kMaxJointStep = 0.2;
// [m^3] A leg is singular if the determinant of its Jacobian is smaller. Numerical: far below the
// determinant of a regular leg, which is about 0.2^3 = 8e-3 with links of 0.2 m.
constexpr double kMinDeterminant = 1e-7;
}  // namespace

struct StanceKinematics::Pinocchio {
  explicit Pinocchio(const pinocchio::Model& m) : model(m), data(m) {}
  const pinocchio::Model& model;  // owned by robot_
  pinocchio::Data data;
};

StanceKinematics::StanceKinematics(const Robot& robot)
    : pinocchio_(std::make_unique<Pinocchio>(robot.model())),
      robot_(robot),
      q_(robot.q_standing()),
      q_trial_(q_) {
  newton_step(FeetMatrix::Zero(), robot.config().foot_radius * Vector3::UnitZ());
  for (int leg = 0; leg < kLegs; ++leg) depth_sign_[leg] = depth_trial_[leg] < 0.0 ? -1.0 : 1.0;
}
StanceKinematics::~StanceKinematics() = default;
StanceKinematics::StanceKinematics(StanceKinematics&&) noexcept = default;

bool StanceKinematics::solve(const Vector3& p_base, const Quaternion& R_base,
                             const FeetMatrix& contacts, const Vector3& normal) noexcept {
  const Vector3 lever = robot_.config().foot_radius * normal;
  const FeetMatrix centres = contacts.colwise() + lever;
  q_trial_ = q_;
  q_trial_.head<3>() = p_base;
  q_trial_.segment<4>(3) = R_base.coeffs();
  for (int k = 0; k < kMaxNewtonSteps; ++k) {
    const double error = newton_step(centres, lever);
    if (!(error < 10.0)) return false;  // [m] larger than any robot, or infinite
    if (error > kTolerance) continue;
    q_ = q_trial_;
    depth_ = depth_trial_;
    p_com_ = pinocchio::centerOfMass(pinocchio_->model, pinocchio_->data, q_, false);
    return true;
  }
  return false;
}

// Do one Newton step for each leg. Return the largest foot error [m] before the step, or infinity
// if a leg is singular.
double StanceKinematics::newton_step(const FeetMatrix& centres, const Vector3& lever) noexcept {
  auto& [model, data] = *pinocchio_;
  pinocchio::computeJointJacobians(model, data, q_trial_);
  double max_error = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const auto& frame = model.frames[robot_.foot_frame_ids()[leg]];
    const Vector3 p = data.oMi[frame.parentJoint].act(frame.placement.translation());
    Matrix3 J;
    for (int k = 0; k < kLegJoints; ++k) {
      const auto column = data.J.col(robot_.motor_to_v()[3 * leg + k]);
      J.col(k) = column.head<3>() - p.cross(column.tail<3>());
    }
    // Depth of the contact point, as in LegDynamics::depth.
    const Vector3 hip_axis = data.J.col(robot_.motor_to_v()[3 * leg]).tail<3>();
    const Vector3 thigh_axis = data.J.col(robot_.motor_to_v()[3 * leg + 1]).tail<3>();
    depth_trial_[leg] = depth_sign_[leg] * (J.col(0) + lever.cross(hip_axis)).dot(thigh_axis);
    const Vector3 error = centres.col(leg) - p;
    if (!error.allFinite() || std::abs(J.determinant()) < kMinDeterminant) {
      return std::numeric_limits<double>::infinity();
    }
    const Vector3 step = J.inverse() * error;
    for (int k = 0; k < kLegJoints; ++k) {
      q_trial_[robot_.motor_to_q()[3 * leg + k]] +=
          std::clamp(step[k], -kMaxJointStep, kMaxJointStep);
    }
    max_error = std::max(max_error, error.norm());
  }
  return max_error;
}

}  // namespace surefoot
