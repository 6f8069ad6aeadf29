// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/support_frame.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Makes the Reference that holds the body where and as it stood when latched.
///
/// What is kept is relative to the feet: centre of mass from their centroid, yaw from their
/// heading, each foot's place in their frame; roll and pitch from gravity. Real-time: yes.
class StandReference {
 public:
  bool latched() const noexcept { return latched_; }
  void reset() noexcept { latched_ = false; }

  /// Remember how the robot stands.
  void latch(const Dynamics& dynamics) noexcept;

  /// Express what was latched in today's world frame, with the integrals as feed-forward.
  const Reference& update(const Gains& gains, const Dynamics& dynamics,
                          const Eigen::Vector4d& contact, double dt) noexcept;

  const Reference& reference() const noexcept { return reference_; }

 private:
  void follow_ground(const SupportFrame& support, const Eigen::Vector4d& contact,
                     double dt) noexcept;
  void follow_moved_feet(const SupportFrame& support, const Dynamics& dynamics,
                         const Eigen::Vector4d& contact, double dt) noexcept;
  void integrate(const Gains& gains, const Dynamics& dynamics, const Matrix3& R_world_heading,
                 double dt) noexcept;

  bool latched_ = false;
  Vector3 com_from_centroid_ = Vector3::Zero();               // heading axes
  Quaternion R_heading_base_ = Quaternion::Identity();
  FeetMatrix anchors_ = FeetMatrix::Zero();                   // heading axes, from the centroid
  Vector3 normal_ = Vector3::UnitZ();
  Vector3 com_integral_ = Vector3::Zero();                    // [m/s^2] heading axes
  Vector3 base_integral_ = Vector3::Zero();                   // [rad/s^2] heading axes
  Reference reference_;
};

}  // namespace surefoot
