// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Scope in which the calling thread has real-time priority and the process has locked memory, as
/// far as the system permits. The destructor ends both. Real-time: no.
class RealTimeScope {
 public:
  RealTimeScope();
  ~RealTimeScope();
  RealTimeScope(const RealTimeScope&) = delete;
  RealTimeScope& operator=(const RealTimeScope&) = delete;

  /// Return a text that describes the scheduling obtained.
  const std::string& scheduling() const noexcept { return scheduling_; }
  /// Return a text that describes the memory locking obtained.
  const std::string& memory() const noexcept { return memory_; }

 private:
  bool scheduled_ = false, locked_ = false;
  std::string scheduling_, memory_;
};

/// Timer with absolute deadlines, one period apart. Missed periods are skipped: the timer never
/// returns several times in a row to catch up. Real-time: yes.
class PeriodicTimer {
 public:
  /// @param period [s]
  explicit PeriodicTimer(double period);

  /// Sleep until the next deadline. Return at once if the deadline has passed by less than a
  /// period.
  /// @return time from the deadline until waking up [us]
  double wait() noexcept;
  long missed() const noexcept { return missed_; }  ///< number of skipped periods

 private:
  double period_, next_deadline_;
  long missed_ = 0;
};

}  // namespace surefoot
