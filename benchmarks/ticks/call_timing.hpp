// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <time.h>

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

/// One timed call.
struct CallTiming {
  float wall = 0.0F;  ///< [us] wall time
  float cpu = 0.0F;   ///< [us] CPU time of this thread
  std::uint16_t iterations = 0;
  /// 1: the controller used another fallback level than kSolved, or WholeBodyController had no
  /// usable status.
  std::uint16_t failed = 0;
};

/// Timings of one kind of call. Memory for all timings is reserved before the first call.
struct Series {
  Series(std::string n, std::size_t capacity) : name(std::move(n)) { timings.reserve(capacity); }
  std::string name;
  std::vector<CallTiming> timings;
  long walking = 0;      ///< number of timed calls in which the robot stepped
  long allocations = 0;  ///< number of heap allocations in all timed passes
  long page_faults = 0;  ///< number of page faults in all timed passes
  long first_allocations = 0, first_page_faults = 0;  ///< the same counts in the untimed first pass
  bool has_cpu_time = true;
};

inline double nanoseconds(clockid_t clock) noexcept {
  timespec t;
  clock_gettime(clock, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

/// Measure the wall time and the thread's CPU time of a call. Does not allocate.
template <typename Call>
CallTiming time_call(Call&& call) noexcept {
  const double cpu = nanoseconds(CLOCK_THREAD_CPUTIME_ID);
  const double wall = nanoseconds(CLOCK_MONOTONIC);
  call();
  CallTiming timing;
  timing.wall = static_cast<float>(1e-3 * (nanoseconds(CLOCK_MONOTONIC) - wall));
  timing.cpu = static_cast<float>(1e-3 * (nanoseconds(CLOCK_THREAD_CPUTIME_ID) - cpu));
  return timing;
}

}  // namespace bench
