// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "dynamics/dynamics.hpp"
#include "reference/body_motion.hpp"
#include "reference/foot_rolling.hpp"
#include "reference/support_frame.hpp"
#include "reference/three_leg_stance.hpp"
#include "surefoot/planner.hpp"

namespace surefoot {

/// Planner for standing: plans the latched pose of the body, or a pose that a BodyReference
/// requests relative to the latched pose. The first three calls of plan() latch the pose.
///
/// The references of base pose, centre of mass and feet are kept in the support frame, which is
/// fitted to the feet. The pose of this frame relative to the body depends only on the joint angles
/// and, for a few seconds, on the rolling of the feet. Slow errors of the IMU move the frame and
/// the body together, so these errors cannot make the robot lean.
///
/// While no foot is loaded, the frame follows the body, and the legs extend beyond the standing
/// pose by kAirborneExtension. Real-time: yes.
class StandPlanner : public Planner {
 public:
  explicit StandPlanner(const Robot& robot)
      : motion_(robot), foot_rolling_(robot.config().foot_radius) {}

  bool plan(const PlannerInput& input, Reference& reference) noexcept override;
  void reset() noexcept override;
  /// Stop standing: latch the pose of the next plan() again. The height, roll and pitch that were
  /// requested last stay.
  void latch_again() noexcept;
  /// Move height, roll and pitch of a walking robot, relative to the nominal stance, see motion().
  /// @param p_feet contact points FR FL RR RL of the nominal stance, from the centre of mass [m]
  /// @param p_base origin of the base, from the centre of mass [m]
  void move_while_walking(const PlannerInput& input, const FeetMatrix& p_feet,
                          const Vector3& p_base) noexcept;
  void set_target(const BodyReference& target) noexcept { motion_.set_target(target); }

  /// Return whether a pose is latched.
  bool has_latched() const noexcept { return pose_latches_ > 0; }
  const BodyMotion& motion() const noexcept { return motion_; }

 private:
  void latch(const PlannerInput& input) noexcept;
  void update_feet(const PlannerInput& input, const Eigen::Vector4d& contact) noexcept;
  void write(Reference& reference) const noexcept;
  void update_airborne_share(const Eigen::Vector4d& contact, double dt) noexcept;

  BodyMotion motion_;
  SupportFrame support_;
  FootRolling foot_rolling_;
  ThreeLegStance three_leg_stance_;
  // 0: at least one foot is in contact. Near 1: all feet have been in the air for much longer than
  // kAirborneTime. Each tick moves the support frame towards the body by this share.
  double airborne_share_ = 0.0;
  bool walking_ = false;  // since the pose was latched
  int pose_latches_ = 0;  // number of calls of plan() that have latched the pose
};

}  // namespace surefoot
