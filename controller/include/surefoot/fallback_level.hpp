// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// Source of a command, the best first. A tick tries the levels in this order, the fallback chain,
/// until one level gives a command.
enum class FallbackLevel : int {
  kSolved = 0,  ///< the whole-body QP, started from the active set of the last tick
  kColdSolve,   ///< the same QP again, from a cold start, with ten times the tolerance
  kForces,      ///< no QP: the forces of the last solution, plus the change of the desired wrench
                ///< since then, shared among the feet
  kLastForces,  ///< the forces of the last solution, through the present Jacobians
  kGravity,     ///< forces on the feet that carry the weight, and motor-side damping
  kHold,        ///< the last command again: no other level gave a command
  kDamping      ///< the motors brake by themselves
};
constexpr int kFallbackLevels = static_cast<int>(FallbackLevel::kDamping) + 1;
/// Return the name of a level, such as "cold_solve". Real-time: yes.
const char* to_string(FallbackLevel fallback_level) noexcept;

/// Return whether commands of this level are computed from the LowState of the same tick.
/// Real-time: yes.
inline bool is_fresh(FallbackLevel fallback_level) noexcept {
  return fallback_level < FallbackLevel::kHold;
}

}  // namespace surefoot
