// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace surefoot {

/// Real-time priority and locked memory for the calling thread, as far as the system permits. The
/// destructor releases both. Real-time: no.
class RealTimeScope {
 public:
  RealTimeScope();
  ~RealTimeScope();
  RealTimeScope(const RealTimeScope&) = delete;
  RealTimeScope& operator=(const RealTimeScope&) = delete;

  const std::string& scheduling() const noexcept { return scheduling_; }  ///< obtained, in words
  const std::string& memory() const noexcept { return memory_; }          ///< obtained, in words

 private:
  bool scheduled_ = false, locked_ = false;
  std::string scheduling_, memory_;
};

/// Timer with absolute deadlines, one period apart. Missed periods are left out: ticks never run
/// back to back to catch up. Real-time: yes.
class PeriodicTimer {
 public:
  /// @param period [s]
  explicit PeriodicTimer(double period);

  /// Sleep until the next deadline. @return delay from the deadline to waking up [us]
  double wait() noexcept;
  long missed() const noexcept { return missed_; }  ///< periods left out

 private:
  double period_, next_deadline_;
  long missed_ = 0;
};

}  // namespace surefoot
