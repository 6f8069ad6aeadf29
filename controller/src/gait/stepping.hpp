// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/body_trajectory.hpp"
#include "gait/step_schedule.hpp"
#include "gait/swing_feet.hpp"
#include "gait/walk_recovery.hpp"

namespace surefoot {

/// Reference of a robot that steps: the clock lifts feet in turn, each foot lands at its
/// foothold, and the body moves with the commanded velocity. Real-time: yes.
class Stepping {
 public:
  explicit Stepping(const GaitSize& size)
      : size_(size), schedule_(size), feet_(size), body_(size), sway_(size), recovery_(size) {}

  /// Begin at the measured state: all feet stand.
  /// @param ground_normal of the ground under the stand, unit length
  /// @param walk whether the robot walks with three feet down; false: it trots
  /// @param height_offset height of the body above that of the standing pose [m]
  void start(const PlannerInput& input, const Vector3& ground_normal, bool walk,
             const WalkVelocity& command, double height_offset) noexcept;
  /// Begin at the measured state with a trot whose first pair lifts off at once.
  void start_recovery(const PlannerInput& input, const Vector3& ground_normal,
                      double height_offset) noexcept;
  /// @param walk like that of start(). A change to a trot acts at once, a change to a walk when all
  ///   feet stand and the body is slow
  /// @param offset height, roll and pitch of the body relative to those of the standing pose
  /// @param may_stop true: lift no further foot once a stand can stop the body over feet that are
  ///   near their places in the nominal stance, or once a leg is lost
  void plan(const PlannerInput& input, bool walk, const WalkVelocity& command,
            const BodyMotion& offset, bool may_stop, Reference& reference) noexcept;

  /// Return whether the robot has stopped: no foot needs to lift off, all feet except that of a
  /// lost leg are in stance, and without a lost leg the sway is at rest.
  /// @param lost_leg 0 .. 3, or -1
  bool has_stopped(int lost_leg) const noexcept {
    return may_stand_ && contacts().others_in_stance(lost_leg) &&
           (lost_leg >= 0 || sway_.is_at_rest());
  }

  const GaitSize& size() const noexcept { return size_; }
  const FeetMatrix& footholds() const noexcept { return feet_.footholds(); }  ///< [m] world frame
  const FootContacts& contacts() const noexcept { return schedule_.contacts(); }
  const GaitClock& clock() const noexcept { return schedule_.clock(); }
  const StepPattern& pattern() const noexcept { return schedule_.pattern(); }
  const BodyTrajectory& body() const noexcept { return body_; }
  const BodySway& sway() const noexcept { return sway_; }

 private:
  void begin(const PlannerInput& input, const Vector3& ground_normal,
             double height_offset) noexcept;
  HorizontalMotion motion_without_sway(const PlannerInput& input) const noexcept;
  bool can_stand(const PlannerInput& input, const HorizontalMotion& measured) const noexcept;
  void update_schedule(const PlannerInput& input, bool walk, const WalkVelocity& command,
                       const HorizontalMotion& measured, bool steady) noexcept;
  void update_ground(const PlannerInput& input, bool steady) noexcept;
  void update_body(const PlannerInput& input, const WalkVelocity& command,
                   const HorizontalMotion& measured) noexcept;

  GaitSize size_;
  StepSchedule schedule_;
  SwingFeet feet_;
  GroundPlane ground_;
  BodyTrajectory body_;
  BodySway sway_;
  WalkRecovery recovery_;
  bool may_stand_ = false;  // no foot need lift off
};

}  // namespace surefoot
