// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_planner.hpp"

namespace surefoot {

namespace {

// [s] Time after reset() in which the robot stands. Chosen: longer than the 0.2 s in which wrong
// sensors are found before the robot moves.
constexpr double kStandingTime = 0.3;
// [s] Time without any contact after which the robot is lifted or falls. Chosen: longer than the
// flight of a fast trot, 80 ms at h = 0.3 m.
constexpr double kAirborneTime = 0.2;
// Sum of the contact confidences below which no foot is in contact, and confidence that each foot
// must exceed to begin a walk.
constexpr double kContact = 0.5;
// [s] Longest time for which the swing feet of a robot with a lost leg are put down. Chosen: longer
// than a swing. A foot that meets no ground is then a stance foot, as in a stand.
constexpr double kPutDownTime = 0.3;

}  // namespace

WalkPlanner::WalkPlanner(const Robot& robot, double velocity_timeout)
    : WalkPlanner(robot, GaitSize(robot), velocity_timeout) {}

WalkPlanner::WalkPlanner(const Robot& robot, const GaitSize& size, double velocity_timeout)
    : command_(size, velocity_timeout), stand_(robot), stepping_(size) {}

void WalkPlanner::reset() noexcept {
  walking_ = false;
  time_ = airborne_time_ = lost_time_ = 0.0;
  command_.reset();
  stand_.reset();
}

bool WalkPlanner::plan(const PlannerInput& input, Reference& reference) noexcept {
  update_times(input);
  const bool walk = wants_to_walk(input);
  if (!walking_ && !(walk && input.state.contact.minCoeff() > kContact)) {
    return plan_stand(input, reference);
  }
  if (walking_ && !walk && (must_stand() || stepping_.has_stopped(input.lost_leg))) {
    walking_ = false;
    stand_.reset();  // it latches the pose in which the walk ends
    return plan_stand(input, reference);
  }
  if (!walking_) stepping_.start(input, gait_ == Gait::kWalk, command_.velocity());
  walking_ = true;
  stepping_.plan(input, gait_ == Gait::kWalk, command_.velocity(), !walk, reference);
  return true;
}

void WalkPlanner::update_times(const PlannerInput& input) noexcept {
  command_.advance(input.dt);
  time_ += input.dt;
  airborne_time_ = input.state.contact.sum() < kContact ? airborne_time_ + input.dt : 0.0;
  lost_time_ = input.lost_leg >= 0 ? lost_time_ + input.dt : 0.0;
}

bool WalkPlanner::wants_to_walk(const PlannerInput& input) const noexcept {
  if (input.lost_leg >= 0 || time_ < kStandingTime || airborne_time_ > kAirborneTime) return false;
  return !command_.has_expired() && (gait_ == Gait::kTrot || !command_.is_zero());
}

bool WalkPlanner::must_stand() const noexcept {
  return airborne_time_ > kAirborneTime || lost_time_ > kPutDownTime;
}

// The stand does not write the fields that are cleared here.
bool WalkPlanner::plan_stand(const PlannerInput& input, Reference& reference) noexcept {
  reference.stepping = false;
  reference.a_com.setZero();
  for (FootReference& foot : reference.feet) foot = FootReference();
  return stand_.plan(input, reference);
}

}  // namespace surefoot
