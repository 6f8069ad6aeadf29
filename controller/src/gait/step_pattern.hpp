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

/// Return the pattern for a commanded velocity: of a walk, with the best order. At velocity 0 the
/// order does not change. Real-time: yes.
StepPattern suitable_pattern(const StepPattern& present, const Gains& gains, const GaitSize& size,
                             bool walk, const WalkVelocity& command) noexcept;

/// Return the share, 0 .. 1, of the acceleration gains that the body may use: all of them to brake.
/// In a trot each pair of feet stands where it was planned for less speed. A walk reaches its
/// greatest speed in a period: until then, the foot that lifts off last stands where it stood at
/// the beginning. Real-time: yes.
/// @param velocity present velocity of the body trajectory
double acceleration_share(const StepPattern& pattern, const Gains& gains, const GaitSize& size,
                          const WalkVelocity& command, const WalkVelocity& velocity) noexcept;

}  // namespace surefoot
