// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Real-time priority and locked memory for the calling thread, as far as the system permits; given
/// back at the end. Not in the tick.
class RealTimeScope {
 public:
  RealTimeScope();
  ~RealTimeScope();
  RealTimeScope(const RealTimeScope&) = delete;
  RealTimeScope& operator=(const RealTimeScope&) = delete;

  const std::string& scheduling() const noexcept { return scheduling_; }  ///< what was got
  const std::string& memory() const noexcept { return memory_; }          ///< what was got

 private:
  bool scheduled_ = false, locked_ = false;
  std::string scheduling_, memory_;
};

/// Wakes at absolute times, one period apart. A period that has been missed is left out: two ticks
/// are never run back to back to catch up. Real-time: yes.
class PeriodicTimer {
 public:
  explicit PeriodicTimer(double period);

  /// Sleep until the next deadline. @return [us] how late it woke
  double wait() noexcept;
  long missed() const noexcept { return missed_; }  ///< periods left out

 private:
  double period_, next_deadline_;
  long missed_ = 0;
};

}  // namespace surefoot
