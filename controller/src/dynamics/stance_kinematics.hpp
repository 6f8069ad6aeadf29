// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "surefoot/robot.hpp"

namespace surefoot {

/// Inverse kinematics of all four feet for a pose of the base: Newton's method, warm started.
///
/// Any frame will do, as long as pose, contacts and normal are in the same. Real-time: solve() yes.
class StanceKinematics {
 public:
  explicit StanceKinematics(const Robot& robot);
  ~StanceKinematics();
  StanceKinematics(StanceKinematics&&) noexcept;

  /// Begin the next solve from these joints; q of shape (nq,).
  void set_initial_guess(const Eigen::VectorXd& q) noexcept { q_ = q; }

  /// Put the contact points where they are wanted. @return false if a leg does not reach: q() is
  /// then the last one that did
  bool solve(const Vector3& p_base, const Quaternion& R_base, const FeetMatrix& contacts,
             const Vector3& normal) noexcept;

  const Eigen::VectorXd& q() const noexcept { return q_; }
  const Vector3& p_com() const noexcept { return p_com_; }  ///< [m] of the last good solve
  /// Of the feet below their hip axes, each in the plane of its leg [m]; of the last good solve.
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
