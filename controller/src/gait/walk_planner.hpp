// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "gait/stepping.hpp"
#include "gait/velocity_command.hpp"
#include "reference/stand_planner.hpp"

namespace surefoot {

/// Planner that stands, and that trots or walks at a commanded velocity or after a push. Real-time:
/// yes.
///
/// It stands for the first 0.3 s after reset(), in which wrong sensors are found. With a lost leg
/// it puts its swing feet down and stands. In the air it stands. It walks again when all feet are
/// in contact, or when three have been for 0.3 s.
class WalkPlanner : public Planner {
 public:
  /// @param velocity_timeout age above which a commanded velocity becomes 0 [s]
  /// @param power_limit largest power of a command [W], see ControllerOptions
  explicit WalkPlanner(const Robot& robot, double velocity_timeout = 0.5,
                       double power_limit = std::numeric_limits<double>::infinity());

  void set_velocity(const Gains& gains, const WalkVelocity& velocity) noexcept {
    command_.set(gains, gait_, velocity);
  }
  void set_gait(const Gains& gains, Gait gait) noexcept {
    gait_ = gait;
    command_.clamp(gains, gait);
  }
  bool plan(const PlannerInput& input, Reference& reference) noexcept override;
  void reset() noexcept override;

  /// Return whether a pose is latched or the robot walks.
  bool has_started() const noexcept { return walking_ || stand_.has_latched(); }
  bool walking() const noexcept { return walking_; }
  /// Return whether the motors can carry the robot on two feet, see kMaxTrotLoad. If not, the
  /// planner only stands.
  bool can_walk() const noexcept { return can_walk_; }
  Gait gait() const noexcept { return gait_; }
  const VelocityCommand& command() const noexcept { return command_; }
  StandPlanner& stand() noexcept { return stand_; }
  const StandPlanner& stand() const noexcept { return stand_; }
  const Stepping& stepping() const noexcept { return stepping_; }

 private:
  WalkPlanner(const Robot& robot, const GaitSize& size, double velocity_timeout,
              double power_limit);
  void start_walk(const PlannerInput& input, const Vector3& ground_normal, bool recover,
                  bool walk_gait) noexcept;
  void update_times(const PlannerInput& input) noexcept;
  bool wants_to_walk(const PlannerInput& input) const noexcept;
  bool must_step(const PlannerInput& input) const noexcept;
  bool must_stand() const noexcept;
  bool plan_stand(const PlannerInput& input, Reference& reference) noexcept;

  bool can_walk_;
  Gait gait_ = Gait::kAuto;
  bool walking_ = false;
  bool recovering_ = false;     // the robot trots because of a push, not of a command
  double time_ = 0.0;           // [s] since reset()
  double airborne_time_ = 0.0;  // [s] for which no foot has been in contact
  double carried_time_ = 0.0;   // [s] for which at most one foot has not been in contact
  double lost_time_ = 0.0;      // [s] since the leg was lost
  VelocityCommand command_;
  StandPlanner stand_;
  Stepping stepping_;
};

}  // namespace surefoot
