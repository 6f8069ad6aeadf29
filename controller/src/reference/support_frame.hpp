// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/types.hpp"

namespace surefoot {

/// Where the feet are: the frame that standing refers to. Its origin is the centroid of the feet,
/// x points from the rear feet's middle to the front's, z out of the plane of the feet.
///
/// World x, y and yaw of a legged robot drift; a reference that stayed there would lean the robot
/// off its feet. The feet themselves do not drift. Each foot has its place in the frame, and the
/// frame is where it fits these places to the feet that stand: a foot in the air, or one that
/// slides, moves the frame by as much as it is believed, and a foot that stands elsewhere for good
/// takes the frame along slowly. Real-time: yes.
class SupportFrame {
 public:
  /// Take the feet as they are now, all of them standing.
  void latch(const FeetMatrix& p_world_feet) noexcept;

  /// Follow the feet. @param contact belief per foot, 0 .. 1
  void update(const FeetMatrix& p_world_feet, const Eigen::Vector4d& contact, double dt) noexcept;

  /// Go with the body by a share of the way, 0 .. 1: the feet of a robot that is held in the air
  /// have no other place. @param p_support_body of the body in the frame
  void follow_body(const Vector3& p_world_body, const Vector3& p_support_body,
                   double share) noexcept {
    origin_ += share * (p_world_body - R_ * p_support_body - origin_);
  }

  /// Move a foot's place. @param displacement world
  void move_nominal_foot(int leg, const Vector3& displacement) noexcept {
    nominal_feet_.col(leg) += R_.transpose() * displacement;
  }

  const Vector3& origin() const noexcept { return origin_; }  ///< [m] world
  const Matrix3& R_world_support() const noexcept { return R_; }
  Vector3 normal() const noexcept { return R_.col(2); }
  const FeetMatrix& nominal_feet() const noexcept { return nominal_feet_; }  ///< [m] support axes
  FeetMatrix p_world_nominal_feet() const noexcept {
    return (R_ * nominal_feet_).colwise() + origin_;
  }

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
  double time_since_latch_ = 0.0;  // [s] since it was latched
};

}  // namespace surefoot
