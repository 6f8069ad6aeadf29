// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/foot_contacts.hpp"
#include "gait/gait_clock.hpp"
#include "gait/swing_trajectory.hpp"
#include "gait/walking_body.hpp"
#include "surefoot/planner.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Planner of a walking robot: a clock lifts diagonal pairs of feet in turn, feet land where the
/// body will be, and the body moves with the commanded velocity. Real-time: yes.
class WalkPlanner : public Planner {
 public:
  explicit WalkPlanner(const Robot& robot);

  void set_velocity(const VelocityCommand& command) noexcept { command_ = command; }
  bool plan(const PlannerInput& input, Reference& reference) noexcept override;
  void reset() noexcept override;

  const FeetMatrix& footholds() const noexcept { return footholds_; }  ///< [m] world frame
  const FootContacts& contacts() const noexcept { return contacts_; }
  const GaitClock& clock() const noexcept { return clock_; }

 private:
  void start(const PlannerInput& input) noexcept;
  void update_ground(const PlannerInput& input) noexcept;
  void plan_swing(int leg, const PlannerInput& input) noexcept;
  void write_foot(int leg, const PlannerInput& input, FootReference& foot) const noexcept;

  double corner_;
  double height_;            // [m] centre of mass above the ground, standing pose
  FeetMatrix nominal_feet_;  // [m] from the centre of mass, standing pose, heading axes
  VelocityCommand command_;
  bool started_ = false;
  GaitTiming timing_;
  GaitClock clock_;
  FootContacts contacts_;
  WalkingBody body_;
  std::array<SwingTrajectory, kLegs> swings_;
  FeetMatrix footholds_ = FeetMatrix::Zero();
  FeetMatrix landings_ = FeetMatrix::Zero();  // [m] where each foot stood last
  double ground_ = 0.0;                       // [m] mean height of landings_
};

}  // namespace surefoot
