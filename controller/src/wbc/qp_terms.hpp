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

/// A task of the user's, and its rows.
struct CustomTask {
  std::shared_ptr<Task> task;
  TaskRows rows;
  Eigen::VectorXd b;  ///< rows.b, moved to the frame of the program's dynamics
};

/// All that one tick asks of the program, in words that either form understands.
struct QpTerms {
  explicit QpTerms(int joints)
      : limits(joints),
        posture(Eigen::VectorXd::Zero(joints)),
        posture_weight(Eigen::VectorXd::Zero(joints)) {}

  FeetMatrix feet_acceleration = FeetMatrix::Zero();  ///< met exactly, world axes [m/s^2] ...
  Vector6 external_wrench = Vector6::Zero();          ///< wrench on the base, base axes [N], [N.m]
  Condensed condensed;         ///< the equations of motion on the forces alone ...
  bool has_condensed = false;  ///< ... where no leg is singular
  Eigen::Vector4d foot_softness = Eigen::Vector4d::Zero();  ///< ... or, where > 0, at a price
  Eigen::Vector4d weight_foot_soft = Eigen::Vector4d::Zero();
  std::array<BodyRows, 3> body;  ///< position, orientation, angular momentum
  int body_tasks = 0;
  Vector12 forces = Vector12::Zero();  ///< that the program is drawn to [N], FR FL RR RL
  double weight_force = 0.0;
  JointLimits limits;
  Eigen::VectorXd posture;         ///< wanted joint accelerations [rad/s^2]
  Eigen::VectorXd posture_weight;  ///< 0 for joints that something else decides
  bool has_posture = false;
  std::vector<CustomTask> custom;

  Vector3 ground_normal = Vector3::UnitZ();
  Eigen::Vector4d friction = Eigen::Vector4d::Zero();    ///< coefficient per foot
  Eigen::Vector4d normal_max = Eigen::Vector4d::Zero();  ///< [N]; 0: no force of any direction
  Eigen::Vector4d hold_down = Eigen::Vector4d::Zero();   ///< [N]
};

}  // namespace surefoot
