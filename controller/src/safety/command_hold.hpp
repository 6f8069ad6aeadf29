// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/command_times.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Bridges a gap between good commands by what stands in for them, then damps and latches.
///
/// Damping is the motors' own (Kd > 0, dq = 0): it goes on when the program has died. A robot that
/// was never under control is damped without latching. Real-time: yes.
class CommandHold {
 public:
  /// A tick that ended well: this is what leaves.
  const LowCmd& accept(const LowCmd& command) noexcept;

  /// A tick that did not: the last command until kHoldTime after the last good one, then damping,
  /// latched.
  /// @param elapsed [s] this tick's share of time
  const LowCmd& repeat_or_damp(double elapsed, double damping_kd) noexcept;

  /// The same with a command made from today's state in the place of the last one.
  const LowCmd& substitute(const LowCmd& command, double elapsed, double damping_kd) noexcept;

  /// Damping while there is nothing to make a command from. The last good one gets no younger by
  /// it.
  const LowCmd& damp(double damping_kd) noexcept;

  double age() const noexcept { return age_; }  ///< [s] that bad ticks have added to the last good
  const LowCmd& last() const noexcept { return command_; }  ///< that left
  bool latched() const noexcept { return latched_; }
  /// Is what left something else than damping?
  bool in_control() const noexcept { return has_command_ && !latched_; }
  void reset() noexcept { *this = CommandHold(); }

 private:
  LowCmd command_ = init_low_cmd();
  bool has_command_ = false;
  bool latched_ = false;
  double age_ = 0.0;  // [s] of the last good command
};

}  // namespace surefoot
