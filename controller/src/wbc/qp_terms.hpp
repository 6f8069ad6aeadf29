// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "surefoot/task.hpp"
#include "tasks/body_rows.hpp"
#include "wbc/condensation.hpp"
#include "wbc/joint_limits.hpp"

namespace surefoot {

/// A task added by the user, and its rows.
struct CustomTask {
  std::shared_ptr<Task> task;
  TaskRows rows;
  /// rows.b minus the part of the rows on Dynamics::a_base_shift(), so that b fits the base
  /// acceleration of the QP.
  Eigen::VectorXd b;
};

/// The tasks and constraints of one tick, independent of the form. CondensedQp and GeneralQp build
/// their matrices from these terms.
struct QpTerms {
  explicit QpTerms(int joints)
      : limits(joints),
        posture(Eigen::VectorXd::Zero(joints)),
        posture_weight(Eigen::VectorXd::Zero(joints)) {}

  /// Desired acceleration of each contact point, world axes [m/s^2].
  FeetMatrix feet_acceleration = FeetMatrix::Zero();
  /// External wrench on the base about its origin, base axes [N], [N.m].
  Vector6 external_wrench = Vector6::Zero();
  Condensed condensed;  ///< condensed equations of motion; valid if has_condensed
  /// Whether `condensed` is valid. It is not if a leg is singular, or if the robot has joints
  /// outside the legs.
  bool has_condensed = false;
  /// Softness of each foot, 0 .. 1 (FormSelector). 0: the foot acceleration is an equality. Above
  /// 0: the foot acceleration is a task in the cost.
  Eigen::Vector4d foot_softness = Eigen::Vector4d::Zero();
  /// Weight of the foot acceleration task, for each foot whose softness is above 0.
  Eigen::Vector4d weight_foot_soft = Eigen::Vector4d::Zero();
  std::array<BodyRows, 3> body;        ///< position, orientation, angular momentum
  int body_tasks = 0;                  ///< number of entries of `body` in use
  Vector12 forces = Vector12::Zero();  ///< desired contact forces [N], FR FL RR RL, world axes
  double weight_force = 0.0;           ///< weight of the deviation from these forces
  JointLimits limits;
  /// [rad/s^2] Desired joint accelerations of the posture task.
  Eigen::VectorXd posture;
  /// Weight of the posture task for each joint; 0: the task does not act on the joint.
  Eigen::VectorXd posture_weight;
  bool has_posture = false;
  std::vector<CustomTask> custom;

  Vector3 ground_normal = Vector3::UnitZ();
  Eigen::Vector4d friction = Eigen::Vector4d::Zero();  ///< friction coefficient of each foot
  /// [N] Largest normal force of each foot; 0: no contact force at all.
  Eigen::Vector4d normal_max = Eigen::Vector4d::Zero();
  /// [N] Smallest normal force of each foot; 0: no hold-down.
  Eigen::Vector4d hold_down = Eigen::Vector4d::Zero();
};

}  // namespace surefoot
