// SPDX-License-Identifier: BSD-3-Clause
#include "gait/sway_input.hpp"

#include <limits>

#include "gait/foothold.hpp"

namespace surefoot {

namespace {

NextSwing next_swing(const StepState& steps, const PlannerInput& input, int leg) noexcept {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const GaitClock& clock = steps.clock;
  const Eigen::Vector2d stands = input.p_feet.col(leg).head<2>();
  if (!steps.pattern.walk) return {kNever, kNever, kNever, stands, stands};
  if (clock.in_swing(leg)) {
    return {0.0, clock.time_to_touchdown(leg), 0.0, stands, steps.footholds.col(leg).head<2>()};
  }
  const double begin = clock.waits(leg) ? 0.0 : clock.time_to_liftoff(leg),
               end = begin + clock.timing().swing_time();
  const Eigen::Vector2d lands = foothold(input.gains, steps.size, steps.body.motion(), steps.body,
                                         leg, end, clock.timing().stance_time());
  return {begin, end, clock.time_since_touchdown(leg), stands, lands};
}

}  // namespace

BodySway::Input sway_input(const StepState& steps, const PlannerInput& input) noexcept {
  const GaitTiming& timing = steps.clock.timing();
  const HorizontalMotion body = steps.body.motion();
  BodySway::Input sway{body.p_com, body.v_com, steps.body.a_world(), {}, {},
                       0.0,        0.0,        steps.body.change()};
  for (int leg = 0; leg < kLegs; ++leg) {
    sway.swings[leg] = next_swing(steps, input, leg);
    sway.stance[leg] = steps.pattern.walk && steps.contacts.in_stance(leg);
  }
  // The time between two swings.
  sway.shift_time = (timing.duty - 0.75) * timing.period;
  sway.margin = input.gains.walk_gait_margin * steps.size.height;
  return sway;
}

}  // namespace surefoot
