// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include "surefoot/fault.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/supervisor.hpp"

namespace surefoot {

/// One tick of a StandRunner: what it knew of the robot, and what it sent.
struct RunTick {
  double time = 0.0;                       ///< [s] since run() began
  bool has_new_state = false;              ///< did the LowState come with this tick?
  Mode mode = Mode::kPassive;              ///< of the supervisor, after it
  FaultId damping_fault = FaultId::kNone;  ///< why the supervisor damped since it was armed
  LowState state = init_low_state();       ///< the newest
  LowCmd command = init_low_cmd();         ///< given to the link, which sends one in every tick
};
static_assert(std::is_trivially_copyable_v<RunTick>);  // add() neither allocates nor throws

/// The last ticks of a run, some 1.7 kB each, for who asks afterwards what happened. It never
/// grows.
class RunLog {
 public:
  /// @param capacity ticks that are kept; 0: none
  explicit RunLog(std::size_t capacity = 0) : ticks_(capacity) {}

  /// Take a tick down; the oldest makes room. Real-time: yes.
  void add(const RunTick& tick) noexcept {
    if (ticks_.empty()) return;
    ticks_[added_ % ticks_.size()] = tick;
    ++added_;
  }

  std::size_t size() const noexcept { return added_ < ticks_.size() ? added_ : ticks_.size(); }
  /// The oldest first; k must be below size(). Real-time: yes.
  const RunTick& operator[](std::size_t k) const noexcept {
    return ticks_[(added_ - size() + k) % ticks_.size()];
  }

 private:
  std::vector<RunTick> ticks_;
  std::size_t added_ = 0;
};

}  // namespace surefoot
