// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/stepping.hpp"
#include "gait/velocity_command.hpp"
#include "reference/stand_planner.hpp"

namespace surefoot {

/// Planner of a robot that walks, and stands while nothing asks it to walk. Real-time: yes.
class WalkPlanner : public Planner {
 public:
  /// @param velocity_timeout age above which a commanded velocity becomes 0 [s]
  WalkPlanner(const Robot& robot, double velocity_timeout);

  void set_velocity(const Gains& gains, const WalkVelocity& velocity) noexcept {
    command_.set(gains, velocity);
  }
  void set_gait(Gait gait) noexcept { gait_ = gait; }
  bool plan(const PlannerInput& input, Reference& reference) noexcept override;
  void reset() noexcept override;

  bool walking() const noexcept { return walking_; }
  Gait gait() const noexcept { return gait_; }
  const VelocityCommand& command() const noexcept { return command_; }
  const Stepping& stepping() const noexcept { return stepping_; }
  const StandPlanner& stand() const noexcept { return stand_; }

 private:
  WalkPlanner(const Robot& robot, const GaitSize& size, double velocity_timeout);
  bool wants_to_walk(const PlannerInput& input) const noexcept;
  void stop_walking(Reference& reference) noexcept;

  Gait gait_ = Gait::kAuto;
  bool walking_ = false;
  VelocityCommand command_;
  StandPlanner stand_;
  Stepping stepping_;
};

}  // namespace surefoot
