// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/stance_kinematics.hpp"
#include "surefoot/body_reference.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// What a pose of the base would break.
struct ReachResult {
  ReachStatus status;
  double violation = 0.0;  ///< [rad] or as bad; 0: nothing
};

/// Judges whether the robot can stand with its base in a pose, in the support frame.
///
/// All feet by inverse kinematics, every joint at least reach_joint_margin inside its limits and
/// every foot at least reach_foot_depth below its hip axis; the centre of mass, projected along
/// gravity, at least reach_support_margin inside the polygon of the feet. For standing this stands
/// in for self-collision constraints: legs that keep their feet in place and their joints in range
/// do not meet (those of a robot that steps, foot_step, may). Real-time: yes.
class ReachCheck {
 public:
  explicit ReachCheck(const Robot& robot) : robot_(robot), kinematics_(robot) {}

  void set_initial_guess(const Eigen::VectorXd& q) noexcept { kinematics_.set_initial_guess(q); }

  /// @param feet contact points @param gravity unit, support axes
  ReachResult evaluate(const Gains& gains, const Vector3& p_base, const Quaternion& R_base,
                       const FeetMatrix& feet, const Vector3& gravity) noexcept;

  /// Centre of mass of the pose judged last [m], if it was not kUnreachable.
  const Vector3& p_com() const noexcept { return kinematics_.p_com(); }

 private:
  Robot robot_;
  StanceKinematics kinematics_;
};

}  // namespace surefoot
