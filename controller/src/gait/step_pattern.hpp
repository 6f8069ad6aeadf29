// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gait/walk_order.hpp"
#include "surefoot/gains.hpp"

namespace surefoot {

/// Which feet step together, and in which order. Real-time: yes.
struct StepPattern {
  bool walk = false;                       ///< false: trot, diagonal pairs in turn
  WalkOrder order = {RR_, FR_, RL_, FL_};  ///< of the walk; a trot ignores it
  bool operator==(const StepPattern& other) const noexcept {
    return walk == other.walk && (!walk || order == other.order);
  }
};

/// Return the pattern for a commanded velocity; a walk has the best order of its feet. At velocity
/// 0 the order does not change. Real-time: yes.
StepPattern suitable_pattern(const StepPattern& present, const Gains& gains, const GaitSize& size,
                             bool walk, const WalkVelocity& command) noexcept;

/// Return the factor, 0 .. 1, on the acceleration gains. To brake it is 1. A trot accelerates with
/// less, because the stance feet were placed for a lower speed. A walk reaches its largest speed
/// after one period, because its last foot first lifts off at the end of that period. Real-time:
/// yes.
/// @param velocity present velocity of the body trajectory
double acceleration_share(const StepPattern& pattern, const Gains& gains, const GaitSize& size,
                          const WalkVelocity& command, const WalkVelocity& velocity) noexcept;

}  // namespace surefoot
