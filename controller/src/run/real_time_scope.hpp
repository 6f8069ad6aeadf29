// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Scope in which the calling thread has real-time priority and locked memory, as far as the system
/// permits. The destructor releases both. Real-time: no.
class RealTimeScope {
 public:
  RealTimeScope();
  ~RealTimeScope();
  RealTimeScope(const RealTimeScope&) = delete;
  RealTimeScope& operator=(const RealTimeScope&) = delete;

  /// Return the scheduling obtained, in words.
  const std::string& scheduling() const noexcept { return scheduling_; }
  /// Return the memory locking obtained, in words.
  const std::string& memory() const noexcept { return memory_; }

 private:
  bool scheduled_ = false, locked_ = false;
  std::string scheduling_, memory_;
};

/// Timer with absolute deadlines, one period apart. The timer skips missed periods, so ticks never
/// run back to back to catch up. Real-time: yes.
class PeriodicTimer {
 public:
  /// @param period [s]
  explicit PeriodicTimer(double period);

  /// Sleep until the next deadline. @return delay from the deadline to waking up [us]
  double wait() noexcept;
  long missed() const noexcept { return missed_; }  ///< number of periods skipped

 private:
  double period_, next_deadline_;
  long missed_ = 0;
};

}  // namespace surefoot
