// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/body_motion.hpp"
#include "reference/foot_rolling.hpp"
#include "reference/recovery_steps.hpp"
#include "reference/support_frame.hpp"
#include "reference/three_leg_stance.hpp"

namespace surefoot {

/// Makes the Reference that holds the body where it stood when latched, or where a BodyReference
/// asks it to be from there.
///
/// Everything is kept in the support frame, which joint angles determine, but for what the feet
/// rolled in the last seconds: base pose, centre of mass and the feet's own places. The IMU's slow
/// errors move that frame and the body together and so cannot lean the robot. While no foot bears
/// anything the frame goes with the body, and the legs of a robot that is lifted come back to its
/// standing pose. Near the edge of balance feet step, see RecoverySteps.
/// Real-time: yes.
class StandReference {
 public:
  explicit StandReference(const Robot& robot)
      : motion_(robot), foot_rolling_(robot.config().foot_radius) {}

  /// Remember how the robot stands; q: its joints.
  void latch(const Dynamics& dynamics, const Eigen::VectorXd& q) noexcept;

  void reset() noexcept {
    reference_ = {};
    motion_.reset();
    three_leg_stance_.reset();
    recovery_steps_.reset();
    airborne_share_ = 0.0;
  }
  /// From now on this leg's foot bears nothing; until reset().
  void give_up_leg(int leg) noexcept { three_leg_stance_.give_up_leg(leg); }
  int lost_leg() const noexcept { return three_leg_stance_.lost_leg(); }
  void set_target(const BodyReference& target) noexcept { motion_.set_target(target); }

  /// Express what is asked in today's world frame.
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
  double airborne_share_ = 0.0;  // share by which the frame goes with the body
  Reference reference_;
};

}  // namespace surefoot
