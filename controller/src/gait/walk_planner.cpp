// SPDX-License-Identifier: BSD-3-Clause
#include "gait/walk_planner.hpp"

#include <algorithm>

#include "gait/trot_load.hpp"
#include "reference/capture_margin.hpp"

namespace surefoot {

namespace {

// [s] Time after reset() in which the robot stands. Chosen: longer than the 0.2 s in which wrong
// sensors are found before the robot moves.
constexpr double kStandingTime = 0.3;
// [s] Time without any contact after which the robot is lifted or falls. Chosen: longer than the
// flight of a fast trot, 80 ms at h = 0.3 m.
constexpr double kAirborneTime = 0.2;
// Sum of the contact confidences below which no foot is in contact, and confidence that all feet
// must exceed to begin a walk. Three feet suffice after kStandingTime: on a slope the fourth one
// may carry next to nothing.
constexpr double kContact = 0.5;
// [s] Longest time for which the swing feet of a robot with a lost leg are put down. Chosen: longer
// than a swing. A foot that meets no ground is then a stance foot, as in a stand.
constexpr double kPutDownTime = 0.3;
// Contact confidence below which a standing foot has lost contact. Chosen as in FootContacts.
constexpr double kLostContact = 0.3;

}  // namespace

WalkPlanner::WalkPlanner(const Robot& robot, double velocity_timeout, double power_limit)
    : WalkPlanner(robot, GaitSize(robot), velocity_timeout, power_limit) {}

WalkPlanner::WalkPlanner(const Robot& robot, const GaitSize& size, double velocity_timeout,
                         double power_limit)
    : can_walk_(trot_load(robot).share <= kMaxTrotLoad),
      command_(size, velocity_timeout, power_limit / (robot.mass() * kGravity * size.speed)),
      stand_(robot),
      stepping_(size) {}

void WalkPlanner::reset() noexcept {
  walking_ = recovering_ = false;
  time_ = airborne_time_ = carried_time_ = lost_time_ = 0.0;
  command_.reset();
  stand_.reset();
}

bool WalkPlanner::plan(const PlannerInput& input, Reference& reference) noexcept {
  update_times(input);
  const bool walk = wants_to_walk(input);
  const bool recover = !walking_ && must_step(input);
  const bool carried = input.state.contact.minCoeff() > kContact || carried_time_ > kStandingTime;
  const bool may_walk = walk && carried;
  if (!walking_ && !recover && !may_walk) {
    return plan_stand(input, reference);
  }
  if (walking_ && !walk && (must_stand() || stepping_.has_stopped(input.lost_leg))) {
    walking_ = recovering_ = false;
    stand_.latch_again();  // the pose in which the walk ends
    return plan_stand(input, reference);
  }
  recovering_ = !walk && (recovering_ || recover);
  const bool walk_gait = gait_ == Gait::kWalk && !recovering_;
  if (!walking_) start_walk(input, reference.ground_normal, recover, walk_gait);
  const GaitSize& size = stepping_.size();
  stand_.move_while_walking(input, size.nominal_feet, size.nominal_base);
  walking_ = true;
  stepping_.plan(input, walk_gait, command_.velocity(), stand_.motion(), !walk, reference);
  return true;
}

void WalkPlanner::start_walk(const PlannerInput& input, const Vector3& ground_normal, bool recover,
                             bool walk_gait) noexcept {
  const double height = stand_.motion().relative_pose().height;
  if (recover) {
    stepping_.start_recovery(input, ground_normal, height);
  } else {
    stepping_.start(input, ground_normal, walk_gait, command_.velocity(), height);
  }
}

void WalkPlanner::update_times(const PlannerInput& input) noexcept {
  command_.advance(input.dt);
  time_ += input.dt;
  airborne_time_ = input.state.contact.sum() < kContact ? airborne_time_ + input.dt : 0.0;
  const bool mostly_carried = (input.state.contact.array() > kContact).count() >= 3;
  carried_time_ = mostly_carried ? carried_time_ + input.dt : 0.0;
  lost_time_ = input.lost_leg >= 0 ? lost_time_ + input.dt : 0.0;
}

bool WalkPlanner::wants_to_walk(const PlannerInput& input) const noexcept {
  if (input.lost_leg >= 0 || time_ < kStandingTime || airborne_time_ > kAirborneTime) return false;
  return can_walk_ && !command_.has_expired() && (gait_ == Gait::kTrot || !command_.is_zero());
}

// Return whether a standing robot must step: the capture point leaves the polygon of the feet. With
// two feet off the ground it steps earlier, because the body already turns about the others.
bool WalkPlanner::must_step(const PlannerInput& input) const noexcept {
  if (!can_walk_ || input.lost_leg >= 0) return false;
  if (time_ < kStandingTime || airborne_time_ > 0.0) return false;
  const bool tips = (input.state.contact.array() < kLostContact).count() >= 2;
  const double margin =
      tips ? input.gains.recovery_margin : std::min(input.gains.recovery_margin, 0.0);
  return capture_margin(input.dynamics, {true, true, true, true}) <
         margin * stepping_.size().height;
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
