// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// Where a command comes from: the rungs of the ladder, the best first. A tick goes down it until
/// one holds.
enum class FallbackLevel : int {
  kSolved = 0,  ///< the whole-body program, from the rows that were active last
  kColdSolve,   ///< the same program once more, from nothing and to a relaxed tolerance
  kForces,      ///< no program: the last forces, and what the tasks' wrench has changed since,
                ///< shared among the feet
  kLastForces,  ///< the last solution's forces, through today's Jacobians
  kGravity,     ///< the weight shared among the feet, and damping of the joints
  kHold,        ///< the command that left last, once more: nothing is known of today
  kDamping      ///< the motors brake by themselves
};
constexpr int kFallbackLevels = static_cast<int>(FallbackLevel::kDamping) + 1;
const char* to_string(FallbackLevel fallback_level) noexcept;

/// Is the command made from the tick's own LowState?
inline bool is_fresh(FallbackLevel fallback_level) noexcept {
  return fallback_level < FallbackLevel::kHold;
}

}  // namespace surefoot
