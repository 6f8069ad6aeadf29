// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Frame of the stance feet, in which the reference of a standing robot is kept.
///
/// The origin is the centroid of the nominal foot positions. The x axis points from the centre of
/// the rear feet to the centre of the front feet, the z axis along the normal of their plane.
///
/// The estimated x, y and yaw of a legged robot drift in the world frame. A reference that is fixed
/// in the world frame would slowly move the body off its feet. So each foot has a nominal position
/// in the support frame. The frame is the weighted least-squares fit of these positions to the
/// measured feet, with the contact confidences as weights. The nominal position of a loaded foot
/// follows the foot slowly. Real-time: yes.
class SupportFrame {
 public:
  /// Latch the present feet as nominal positions. All feet must stand on the ground.
  /// @param p_world_feet contact points, FR FL RR RL, world frame [m]
  void latch(const FeetMatrix& p_world_feet) noexcept;

  /// Fit the frame to the feet.
  /// @param p_world_feet contact points, FR FL RR RL, world frame [m]
  /// @param contact contact confidence per foot, 0 .. 1
  void update(const FeetMatrix& p_world_feet, const Eigen::Vector4d& contact, double dt) noexcept;

  /// Move the origin with the body while the robot is in the air, where no foot determines the
  /// frame.
  /// @param p_world_body measured position of the body, world frame [m]
  /// @param p_support_body desired position of the body, support frame [m]
  /// @param share 0: the origin does not move. 1: the body is at p_support_body afterwards
  void follow_body(const Vector3& p_world_body, const Vector3& p_support_body,
                   double share) noexcept {
    origin_ += share * (p_world_body - R_ * p_support_body - origin_);
  }

  const Vector3& origin() const noexcept { return origin_; }  ///< [m] world frame
  const Matrix3& R_world_support() const noexcept { return R_; }
  Vector3 normal() const noexcept { return R_.col(2); }
  const FeetMatrix& nominal_feet() const noexcept { return nominal_feet_; }  ///< [m] support frame

 private:
  void update_normal(const FeetMatrix& from_mean, const FeetMatrix& nominal_feet,
                     const Eigen::Vector4d& weight, double blend) noexcept;
  void update_heading(const FeetMatrix& from_mean, const FeetMatrix& nominal_feet,
                      const Eigen::Vector4d& weight) noexcept;
  void update_nominal_feet(const FeetMatrix& p, const Eigen::Vector4d& contact,
                           const Eigen::Vector4d& weight, double dt) noexcept;

  Vector3 origin_ = Vector3::Zero();
  Matrix3 R_ = Matrix3::Identity();
  FeetMatrix nominal_feet_ = FeetMatrix::Zero();
  double time_since_latch_ = 0.0;  // [s]
};

}  // namespace surefoot
