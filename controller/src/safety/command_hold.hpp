// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/command_times.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Command hold: bridges a short time without a good command, then latches damping.
///
/// Until kHoldTime after the last good command, the command hold repeats this command or returns a
/// fallback command. After that it latches damping: the motor drivers then brake by themselves
/// (Kd > 0, dq = 0), even if this process dies. Before the first good command it returns damping
/// without latching. Real-time: yes.
class CommandHold {
 public:
  /// Store and return the good command of this tick. The age becomes 0.
  const LowCmd& accept(const LowCmd& command) noexcept;

  /// Return the command for a tick without a good command. Until kHoldTime after the last good
  /// command, return the last command again; after that, latch and return damping. Before the first
  /// good command, return damping without latching it.
  /// @param elapsed duration of this tick [s]
  /// @param damping_kd Kd of damping [N.m.s/rad]
  const LowCmd& repeat_or_damp(double elapsed, double damping_kd) noexcept;

  /// Do the same as repeat_or_damp(), but return `command` instead of the last command. `command`
  /// is a fallback command, computed from the present state.
  const LowCmd& substitute(const LowCmd& command, double elapsed, double damping_kd) noexcept;

  /// Latch damping at once, whether or not a command was accepted.
  const LowCmd& latch(double damping_kd) noexcept;

  /// Return damping without latching it, for a period without a sample. The age of the last good
  /// command stays unchanged.
  const LowCmd& damp(double damping_kd) noexcept;

  double age() const noexcept { return age_; }  ///< [s] time since the last good command
  const LowCmd& last() const noexcept { return command_; }  ///< command that was returned last
  bool latched() const noexcept { return latched_; }
  /// Return whether there has been a good command and damping is not latched.
  bool in_control() const noexcept { return has_command_ && !latched_; }
  void reset() noexcept { *this = CommandHold(); }

 private:
  LowCmd command_ = init_low_cmd();
  bool has_command_ = false;
  bool latched_ = false;
  double age_ = 0.0;  // [s] age of the last good command
};

}  // namespace surefoot
