// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/robot.hpp"

namespace surefoot {

/// Inverse kinematics of all four legs for a given pose of the base, by Newton's method. The
/// initial guess is the last solution.
///
/// Pose, contact points and normal must be in one common frame; any frame is valid.
/// Real-time: solve() yes.
class StanceKinematics {
 public:
  explicit StanceKinematics(const Robot& robot);
  ~StanceKinematics();
  StanceKinematics(StanceKinematics&&) noexcept;

  /// Set the initial guess of the next solve().
  /// @param q configuration, shape (nq,)
  void set_initial_guess(const Eigen::VectorXd& q) noexcept { q_ = q; }

  /// Find the joint angles that put the feet at the contact points.
  /// @param contacts contact points FR FL RR RL [m]
  /// @param normal ground normal, unit length
  /// @return false if a leg cannot reach its contact point; the results then stay unchanged
  bool solve(const Vector3& p_base, const Quaternion& R_base, const FeetMatrix& contacts,
             const Vector3& normal) noexcept;

  const Eigen::VectorXd& q() const noexcept { return q_; }
  /// Centre of mass [m] of the last solution, in the frame of solve().
  const Vector3& p_com() const noexcept { return p_com_; }
  /// Depth [m] of each contact point below its hip axis, in the leg's plane, of the last solution.
  const Eigen::Vector4d& depth() const noexcept { return depth_; }

 private:
  double newton_step(const FeetMatrix& centres, const Vector3& lever) noexcept;

  struct Pinocchio;
  std::unique_ptr<Pinocchio> pinocchio_;
  Robot robot_;
  Eigen::VectorXd q_, q_trial_;
  Vector3 p_com_ = Vector3::Zero();
  Eigen::Vector4d depth_sign_ = Eigen::Vector4d::Ones();
  Eigen::Vector4d depth_ = Eigen::Vector4d::Zero(), depth_trial_ = depth_;
};

}  // namespace surefoot
