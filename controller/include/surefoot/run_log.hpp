// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include "surefoot/fault.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/supervisor.hpp"

namespace surefoot {

/// One tick of a Runner: its newest sample and its command.
struct RunTick {
  double time = 0.0;                       ///< [s] since run() began
  bool has_new_state = false;              ///< true if `state` arrived in this tick
  Mode mode = Mode::kPassive;              ///< mode of the supervisor after the tick
  FaultId damping_fault = FaultId::kNone;  ///< fault for which damping was last latched
  WalkVelocity velocity;      ///< velocity passed to Supervisor::set_velocity() before the tick
  bool has_velocity = false;  ///< whether there was such a call
  Gait gait = Gait::kAuto;    ///< gait of the mode kWalk
  LowState state = init_low_state();  ///< newest sample
  LowCmd command = init_low_cmd();    ///< command passed to the link in this tick
};
static_assert(std::is_trivially_copyable_v<RunTick>);  // add() neither allocates nor throws

/// Ring buffer of the last ticks of a run, for later analysis. A tick takes about 1.7 kB. All
/// memory is allocated by the constructor.
class RunLog {
 public:
  /// Create an empty log.
  /// @param capacity number of ticks that are kept; 0: none
  explicit RunLog(std::size_t capacity = 0) : ticks_(capacity) {}

  /// Add a tick; a full log drops its oldest one. Real-time: yes.
  void add(const RunTick& tick) noexcept {
    if (ticks_.empty()) return;
    ticks_[added_count_ % ticks_.size()] = tick;
    ++added_count_;
  }

  /// Return the number of ticks that are kept now. Real-time: yes.
  std::size_t size() const noexcept {
    return added_count_ < ticks_.size() ? added_count_ : ticks_.size();
  }
  /// Return tick k, counted from the oldest, 0. k must be less than size(). Real-time: yes.
  const RunTick& operator[](std::size_t k) const noexcept {
    return ticks_[(added_count_ - size() + k) % ticks_.size()];
  }

 private:
  std::vector<RunTick> ticks_;
  std::size_t added_count_ = 0;
};

}  // namespace surefoot
