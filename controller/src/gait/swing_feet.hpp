// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/ground_plane.hpp"
#include "gait/step_schedule.hpp"
#include "gait/swing_clearance.hpp"
#include "gait/swing_trajectory.hpp"

namespace surefoot {

/// Where the feet step: each swing foot moves to its foothold, lifts over an obstacle, or reaches
/// down for the ground. Real-time: yes.
class SwingFeet {
 public:
  explicit SwingFeet(const GaitSize& size) : size_(size), stumble_(size), clearance_(size) {}

  /// Begin with all feet on the ground.
  void start(const FeetMatrix& p_world_feet) noexcept;

  /// Judge what stops the swing feet.
  /// @param schedule of the last tick
  /// @param steady true unless the velocity error shows a push. After a push, feet lag behind their
  ///   references and land early without an obstacle
  /// @return the contact confidences, but 0 of a foot that lifts over an obstacle and has not
  ///   landed
  Eigen::Vector4d judge_contacts(const PlannerInput& input, const StepSchedule& schedule,
                                 const GroundPlane& ground, bool steady) noexcept;
  /// Update the height of the swings.
  /// @param speed of the fastest hip [m/s]
  void update_clearance(const PlannerInput& input, const FootContacts& contacts,
                        const GroundPlane& ground, bool steady, double speed) noexcept;
  /// Advance the motion of a foot.
  /// @param steady as in judge_contacts(). After a push no gap between left and right legs is
  ///   kept: pushed robots then fall less often
  void plan(int leg, const PlannerInput& input, const StepSchedule& schedule,
            const HorizontalMotion& measured, const BodyTrajectory& body, const GroundPlane& ground,
            bool steady) noexcept;
  /// Write the reference of a foot.
  void write(int leg, const PlannerInput& input, const FootContacts& contacts,
             FootReference& foot) const noexcept;

  const Stumble& stumble() const noexcept { return stumble_; }
  const FeetMatrix& footholds() const noexcept { return footholds_; }  ///< [m] world frame

 private:
  void swing(int leg, const PlannerInput& input, const StepSchedule& schedule,
             double time_left) noexcept;
  /// Return where the foot on the other side stands or will land, world x and y [m].
  Eigen::Vector2d foot_across(int leg, const PlannerInput& input,
                              const FootContacts& contacts) const noexcept;

  GaitSize size_;
  Stumble stumble_;
  SwingClearance clearance_;
  std::array<SwingTrajectory, kLegs> swings_;
  FeetMatrix footholds_ = FeetMatrix::Zero();
};

}  // namespace surefoot
