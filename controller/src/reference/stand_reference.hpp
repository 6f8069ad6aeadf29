// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/support_frame.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Makes the Reference that holds the body where and as it stood when latched.
///
/// Everything is kept in the support frame, which joint angles alone determine: centre of mass,
/// orientation and the feet's own places. The IMU's slow errors move that frame and the body
/// together and so cannot lean the robot. Real-time: yes.
class StandReference {
 public:
  /// Remember how the robot stands.
  void latch(const Dynamics& dynamics) noexcept;

  /// Express what was latched in today's world frame, with the integrals as feed-forward.
  const Reference& update(const Gains& gains, const Dynamics& dynamics,
                          const Eigen::Vector4d& contact, double dt) noexcept;

  const Reference& reference() const noexcept { return reference_; }

 private:
  void follow_ground(const SupportFrame& support, const Eigen::Vector4d& contact,
                     double dt) noexcept;
  void follow_moved_feet(const SupportFrame& support, const Matrix3& R_world_support,
                         const Dynamics& dynamics, const Eigen::Vector4d& contact,
                         double dt) noexcept;
  void integrate(const Gains& gains, const Dynamics& dynamics, const Matrix3& R_world_support,
                 double dt) noexcept;

  Vector3 com_from_centroid_ = Vector3::Zero();  // support axes
  Quaternion R_support_base_ = Quaternion::Identity();
  FeetMatrix anchors_ = FeetMatrix::Zero();  // support axes, from the centroid
  Vector3 normal_ = Vector3::UnitZ();
  Vector3 com_integral_ = Vector3::Zero();   // [m/s^2] support axes
  Vector3 base_integral_ = Vector3::Zero();  // [rad/s^2] support axes
  Reference reference_;
};

}  // namespace surefoot
