// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/body_motion.hpp"
#include "reference/foot_rolling.hpp"
#include "reference/recovery_steps.hpp"
#include "reference/support_frame.hpp"
#include "reference/three_leg_stance.hpp"

namespace surefoot {

/// Reference for standing: the latched pose of the body, or a pose that a BodyReference requests
/// relative to the latched pose.
///
/// The references of base pose, centre of mass and feet are kept in the support frame, which is
/// fitted to the feet. The pose of this frame relative to the body depends only on the joint angles
/// and, for a few seconds, on the rolling of the feet. Slow errors of the IMU move the frame and
/// the body together, so these errors cannot make the robot lean.
///
/// While no foot is loaded, the frame follows the body, and the legs extend beyond the standing
/// pose by kAirborneExtension. When the capture point is near a support edge, feet step
/// (RecoverySteps). Real-time: yes.
class StandReference {
 public:
  explicit StandReference(const Robot& robot)
      : motion_(robot), foot_rolling_(robot.config().foot_radius) {}

  /// Latch the present pose.
  /// @param q configuration, shape (nq,)
  void latch(const Dynamics& dynamics, const Eigen::VectorXd& q) noexcept;

  void reset() noexcept {
    reference_ = {};
    motion_.reset();
    three_leg_stance_.reset();
    recovery_steps_.reset();
    airborne_share_ = 0.0;
  }
  /// Declare a leg lost until reset(): the reference plans no load for its foot.
  void declare_leg_lost(int leg) noexcept { three_leg_stance_.declare_leg_lost(leg); }
  int lost_leg() const noexcept { return three_leg_stance_.lost_leg(); }
  void set_target(const BodyReference& target) noexcept { motion_.set_target(target); }

  /// Compute the reference of this tick, in the estimator's world frame.
  /// @param contact_confidence FR FL RR RL, 0 .. 1
  const Reference& update(const Gains& gains, const Dynamics& dynamics,
                          const Eigen::Vector4d& contact_confidence, double dt) noexcept;

  const Reference& reference() const noexcept { return reference_; }
  const BodyMotion& motion() const noexcept { return motion_; }

 private:
  void release_leg(int leg, const Dynamics& dynamics) noexcept;
  void update_airborne_share(const Eigen::Vector4d& contact, double dt) noexcept;

  BodyMotion motion_;
  SupportFrame support_;
  FootRolling foot_rolling_;
  RecoverySteps recovery_steps_;
  ThreeLegStance three_leg_stance_;
  // 0: at least one foot is in contact. Near 1: all feet have been in the air for much longer than
  // kAirborneTime. Each tick moves the support frame towards the body by this share.
  double airborne_share_ = 0.0;
  Reference reference_;
};

}  // namespace surefoot
