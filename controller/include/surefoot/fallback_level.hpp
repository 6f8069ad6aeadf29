// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// Where a command comes from, the best source first. This order is the fallback chain: a tick
/// tries the levels in this order until one level gives a command.
enum class FallbackLevel : int {
  kSolved = 0,  ///< the whole-body QP, started from the active set of the last tick
  kColdSolve,   ///< the same QP again, from a cold start and with ten times the tolerance
  /// No QP: the forces of the last solution. The change of the desired wrench since then is shared
  /// among the feet and added.
  kForces,
  kLastForces,  ///< torques from the forces of the last solution and the present Jacobians
  kGravity,     ///< torques that hold the weight of the robot, and damping by the motors
  kHold,        ///< the last command again: no other level gave a command
  kDamping      ///< the motors brake by themselves
};
/// Number of fallback levels.
constexpr int kFallbackLevels = static_cast<int>(FallbackLevel::kDamping) + 1;
/// Return the name of a level, such as "cold_solve". Real-time: yes.
const char* to_string(FallbackLevel fallback_level) noexcept;

/// Return whether commands of this level are computed from the LowState of the same tick.
/// Real-time: yes.
inline bool is_fresh(FallbackLevel fallback_level) noexcept {
  return fallback_level < FallbackLevel::kHold;
}

}  // namespace surefoot
