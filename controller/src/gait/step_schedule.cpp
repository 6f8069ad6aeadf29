// SPDX-License-Identifier: BSD-3-Clause
#include "gait/step_schedule.hpp"

#include "gait/body_trajectory.hpp"
#include "gait/gait_timing.hpp"
#include "gait/step_timing.hpp"

namespace surefoot {

namespace {

// [period] Longest wait for late feet. Chosen: a foot that meets no ground within this time, 60 ms
// of a period of 0.42 s, has stepped into a hole.
constexpr double kMaxWait = 0.15;
// [walk_gait_speed] Speed below which a trot may change to a walk. Chosen: a little above the
// greatest speed of a walk.
constexpr double kWalkSpeed = 1.1;

}  // namespace

void StepSchedule::start(const Gains& gains, bool walk, const WalkVelocity& command) noexcept {
  changes_pattern_ = false;
  contacts_.start();
  pattern_ = suitable_pattern(pattern_, gains, size_, walk, command);
  clock_.start();
}

void StepSchedule::start_recovery(const Gains& gains, int leg) noexcept {
  changes_pattern_ = false;
  contacts_.start();
  pattern_.walk = false;
  clock_.start_swing(gait_timing(pattern_, gains, size_, {}), leg);
}

void StepSchedule::update_pattern(const Gains& gains, bool walk, const WalkVelocity& command,
                                  double speed) noexcept {
  const StepPattern pattern = suitable_pattern(pattern_, gains, size_, walk, command);
  const double limit = kWalkSpeed * gains.walk_gait_speed * size_.speed;
  changes_pattern_ = !(pattern == pattern_) && (!walk || speed <= limit);
  if (!changes_pattern_ || !contacts_.others_in_stance(-1)) return;
  pattern_ = pattern;
  changes_pattern_ = false;
  clock_.start();
}

void StepSchedule::advance(const PlannerInput& input, const HorizontalMotion& measured,
                           const BodyTrajectory& body, const Eigen::Vector4d& contact,
                           const Stumble& stumble, bool stop) noexcept {
  GaitTiming timing = gait_timing(pattern_, input.gains, size_, body.velocity());
  timing.period *= swing_time_factor(size_, clock_, timing, input.p_feet, measured, body);
  clock_.advance(timing, longest_wait(stumble), stop || changes_pattern_, input.dt);
  contacts_.update(clock_, contact, stumble.lifting(), input.dt);
}

double StepSchedule::longest_wait(const Stumble& stumble) const noexcept {
  if (stumble.any()) return stumble.longest_time();
  // A walk lifts a foot only when the other three carry their full load.
  const bool late = contacts_.late(clock_, pattern_.walk ? 1.0 : 0.0);
  return late ? kMaxWait * clock_.timing().period : 0.0;
}

}  // namespace surefoot
