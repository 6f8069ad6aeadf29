// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/body_motion.hpp"
#include "reference/support_frame.hpp"

namespace surefoot {

/// Makes the Reference that holds the body where it stood when latched, or where a BodyReference
/// asks it to be from there.
///
/// Everything is kept in the support frame, which joint angles alone determine: base pose, centre
/// of mass and the feet's own places. The IMU's slow errors move that frame and the body together
/// and so cannot lean the robot. Real-time: yes.
class StandReference {
 public:
  explicit StandReference(const Robot& robot) : motion_(robot) {}

  /// Remember how the robot stands; q: its joints.
  void latch(const Dynamics& dynamics, const Eigen::VectorXd& q) noexcept;

  void reset() noexcept { motion_.reset(); }
  void set_target(const BodyReference& target) noexcept { motion_.set_target(target); }

  /// Express what is asked in today's world frame.
  const Reference& update(const Gains& gains, const Dynamics& dynamics,
                          const Eigen::Vector4d& contact, double dt) noexcept;

  const Reference& reference() const noexcept { return reference_; }
  const BodyMotion& motion() const noexcept { return motion_; }

 private:
  BodyMotion motion_;
  SupportFrame support_;
  Reference reference_;
};

}  // namespace surefoot
