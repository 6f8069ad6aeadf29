// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/stance_kinematics.hpp"
#include "surefoot/body_reference.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// The most violated limit of a base pose, and its violation.
struct ReachResult {
  ReachStatus status;
  /// [rad] Amount by which the limit is violated; distances are converted by kViolationPerMetre. 0:
  /// no limit is violated.
  double violation = 0.0;
};

/// Checks whether the robot can stand with its base in a given pose, in the support frame.
///
/// Inverse kinematics must find a solution for all feet. Each joint must be at least
/// reach_joint_margin inside its limits. Each foot must be at least reach_foot_depth below its hip
/// axis. The centre of mass, projected along gravity, must be at least reach_support_margin inside
/// the support polygon.
///
/// For a standing robot, these conditions replace self-collision constraints: legs do not collide
/// while their feet stay in place and their joints stay in range. While feet step, this class
/// is not used. Real-time: yes.
class ReachCheck {
 public:
  explicit ReachCheck(const Robot& robot) : robot_(robot), kinematics_(robot) {}

  void set_initial_guess(const Eigen::VectorXd& q) noexcept { kinematics_.set_initial_guess(q); }

  /// Evaluate a pose of the base, given in the support frame.
  /// @param feet contact points, support frame [m]
  /// @param gravity unit vector along gravity, support axes
  ReachResult evaluate(const Gains& gains, const Vector3& p_base, const Quaternion& R_base,
                       const FeetMatrix& feet, const Vector3& gravity) noexcept;

  /// Centre of mass [m], support frame, of the last evaluated pose that was reachable.
  const Vector3& p_com() const noexcept { return kinematics_.p_com(); }

 private:
  Robot robot_;
  StanceKinematics kinematics_;
};

}  // namespace surefoot
