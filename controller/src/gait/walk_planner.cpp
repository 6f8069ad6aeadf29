// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_planner.hpp"

namespace surefoot {

WalkPlanner::WalkPlanner(const Robot& robot, double velocity_timeout)
    : WalkPlanner(robot, GaitSize(robot), velocity_timeout) {}

WalkPlanner::WalkPlanner(const Robot& robot, const GaitSize& size, double velocity_timeout)
    : command_(size, velocity_timeout), stand_(robot), stepping_(size) {}

void WalkPlanner::reset() noexcept {
  walking_ = false;
  command_.reset();
  stand_.reset();
}

bool WalkPlanner::plan(const PlannerInput& input, Reference& reference) noexcept {
  command_.advance(input.dt);
  const bool walk = wants_to_walk(input);
  if (walk && !walking_) stepping_.start(input);
  if (walking_ && !walk && (input.lost_leg >= 0 || stepping_.has_stopped())) {
    stop_walking(reference);
  } else {
    walking_ = walking_ || walk;
  }
  if (!walking_) return stand_.plan(input, reference);
  stepping_.plan(input, command_.velocity(), !walk, reference);
  return true;
}

// The stand must have latched its pose before the first step. On three legs the robot only stands.
bool WalkPlanner::wants_to_walk(const PlannerInput& input) const noexcept {
  if (input.lost_leg >= 0 || !stand_.has_latched()) return false;
  return gait_ == Gait::kTrot || !command_.is_zero();
}

// The stand latches the pose in which the walk ends. It does not write the fields that are cleared
// here.
void WalkPlanner::stop_walking(Reference& reference) noexcept {
  walking_ = false;
  stand_.reset();
  reference.stepping = false;
  reference.a_com.setZero();
  for (FootReference& foot : reference.feet) foot = FootReference();
}

}  // namespace surefoot
