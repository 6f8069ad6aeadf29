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
// [walk_gait_speed] Speed below which a walk begins, or changes the order of its feet. All feet
// then stand for a quarter of a period, in which the body moves by 2 cm at h = 0.3 m. Chosen. If
// larger: the feet stay too far behind.
constexpr double kChangeSpeed = 0.25;
// Share of a walk's swing from which on the foot lands before the robot trots. Before it, a foot of
// the pair that shall swing begins a new swing together with the other foot of the pair. Pushed go1
// fell in 1 of 16 minutes with 0.35 and with 0.6, and in 3 with 0, where the foot always lands
// first.
constexpr double kLateSwing = 0.5;

}  // namespace

void StepSchedule::start(const Gains& gains, bool walk, const WalkVelocity& command) noexcept {
  needs_rest_ = stops_ = false;
  contacts_.start();
  pattern_ = suitable_pattern(pattern_, gains, size_, walk, command);
  clock_.start();
}

void StepSchedule::start_recovery(const Gains& gains, int leg) noexcept {
  needs_rest_ = stops_ = false;
  contacts_.start();
  pattern_.walk = false;
  clock_.start_swing(gait_timing(pattern_, gains, size_, {}), leg);
}

void StepSchedule::trot_at_once(const Gains& gains, const WalkVelocity& velocity, int leg,
                                const Stumble& stumble) noexcept {
  needs_rest_ = stops_ = false;
  pattern_.walk = false;
  const GaitTiming timing = gait_timing(pattern_, gains, size_, velocity);
  for (int swinging = 0; swinging < kLegs; ++swinging) {
    if (!clock_.in_swing(swinging)) continue;
    const bool in_pair = swinging == leg || swinging == diagonal_leg(leg);
    const bool late = stumble.lifting(swinging) || clock_.swing_progress(swinging) > kLateSwing;
    if (!in_pair || late) return clock_.continue_swing(timing, swinging);
    contacts_.restart_swing(swinging);
  }
  clock_.start_swing(timing, leg);
}

void StepSchedule::update_pattern(const Gains& gains, bool walk, const WalkVelocity& command,
                                  const WalkVelocity& velocity) noexcept {
  const StepPattern pattern = suitable_pattern(pattern_, gains, size_, walk, command);
  needs_rest_ = !(pattern == pattern_);
  const double limit = kChangeSpeed * gains.walk_gait_speed * size_.speed;
  stops_ = needs_rest_ && size_.fastest_hip(velocity) <= limit;
  if (!stops_ || !contacts_.others_in_stance(-1)) return;
  pattern_ = pattern;
  needs_rest_ = stops_ = false;
  clock_.start();
}

void StepSchedule::advance(const PlannerInput& input, const HorizontalMotion& measured,
                           const BodyTrajectory& body, const Eigen::Vector4d& contact,
                           const Stumble& stumble, bool stop) noexcept {
  GaitTiming timing = gait_timing(pattern_, input.gains, size_, body.velocity());
  timing.period *= swing_time_factor(size_, clock_, timing, input.p_feet, measured, body);
  clock_.advance(timing, longest_wait(stumble), stop || stops_, input.dt);
  contacts_.update(clock_, contact, stumble.lifting(), input.dt);
}

double StepSchedule::longest_wait(const Stumble& stumble) const noexcept {
  if (stumble.any()) return stumble.longest_time();
  // A walk lifts a foot only when the other three carry their full load.
  const bool late = contacts_.late(clock_, pattern_.walk ? 1.0 : 0.0);
  return late ? kMaxWait * clock_.timing().period : 0.0;
}

}  // namespace surefoot
