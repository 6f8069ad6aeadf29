// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/command_times.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Command hold: continues for a short time without a good command, then latches damping.
///
/// Until kHoldTime after the last good command, it repeats the last command or passes on a fallback
/// command. In damping, the motor drivers brake by themselves (Kd > 0, dq = 0), so damping
/// continues if this process dies. Before the first good command it damps without latching.
/// Real-time: yes.
class CommandHold {
 public:
  /// Store and return the good command of this tick. The age becomes 0.
  const LowCmd& accept(const LowCmd& command) noexcept;

  /// Return the command of a tick without a good command: the last command until kHoldTime after
  /// the last good command, then damping, latched.
  /// @param elapsed duration of this tick [s]
  /// @param damping_kd Kd of damping [N.m.s/rad]
  const LowCmd& repeat_or_damp(double elapsed, double damping_kd) noexcept;

  /// Do the same as repeat_or_damp(), but return `command` instead of the last command: a fallback
  /// command that was computed from the present state.
  const LowCmd& substitute(const LowCmd& command, double elapsed, double damping_kd) noexcept;

  /// Latch damping at once, whether or not a command was accepted.
  const LowCmd& latch(double damping_kd) noexcept;

  /// Return damping without latching it, for a period without a sample. The age of the last good
  /// command does not change.
  const LowCmd& damp(double damping_kd) noexcept;

  double age() const noexcept { return age_; }  ///< [s] time since the last good command
  const LowCmd& last() const noexcept { return command_; }  ///< last command returned
  bool latched() const noexcept { return latched_; }
  /// Return whether a good command was accepted and damping is not latched.
  bool in_control() const noexcept { return has_command_ && !latched_; }
  void reset() noexcept { *this = CommandHold(); }

 private:
  LowCmd command_ = init_low_cmd();
  bool has_command_ = false;
  bool latched_ = false;
  double age_ = 0.0;  // [s] age of the last good command
};

}  // namespace surefoot
