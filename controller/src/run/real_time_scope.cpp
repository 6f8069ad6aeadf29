// SPDX-License-Identifier: BSD-3-Clause
#include "run/real_time_scope.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <time.h>

#include <cerrno>
#include <cmath>
#include <cstring>

#include "common/clock.hpp"

namespace surefoot {

namespace {

// SCHED_FIFO priority, 1 .. 99. Chosen lower than 99, which the kernel's own threads use, and
// higher than 50, which its threaded interrupts use.
constexpr int kPriority = 80;

timespec to_timespec(double seconds) noexcept {
  timespec t;
  t.tv_sec = static_cast<time_t>(seconds);
  t.tv_nsec = static_cast<long>(1e9 * (seconds - std::floor(seconds)));
  return t;
}

}  // namespace

RealTimeScope::RealTimeScope() {
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  const int error_code = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  scheduled_ = error_code == 0;
  scheduling_ = scheduled_ ? "SCHED_FIFO priority " + std::to_string(kPriority)
                           : std::string("ordinary scheduling (SCHED_FIFO: ") +
                                 std::strerror(error_code) + ")";
  rlimit memory_limit{};
  getrlimit(RLIMIT_MEMLOCK, &memory_limit);
  // With MCL_FUTURE, allocations beyond the limit of locked memory would fail. So future memory is
  // locked only if there is no limit.
  const int lock_flags = MCL_CURRENT | (memory_limit.rlim_cur == RLIM_INFINITY ? MCL_FUTURE : 0);
  locked_ = mlockall(lock_flags) == 0;
  const char* locked_text =
      (lock_flags & MCL_FUTURE) != 0 ? "memory locked" : "present memory locked";
  memory_ = locked_ ? std::string(locked_text)
                    : std::string("memory not locked (") + std::strerror(errno) + ")";
}

RealTimeScope::~RealTimeScope() {
  if (locked_) munlockall();
  sched_param ordinary{};
  if (scheduled_) pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
}

PeriodicTimer::PeriodicTimer(double period) : period_(period), next_deadline_(monotonic_time()) {}

double PeriodicTimer::wait() noexcept {
  next_deadline_ += period_;
  const double behind = monotonic_time() - next_deadline_;
  if (behind > period_) {
    const double periods = std::floor(behind / period_);
    missed_ += static_cast<long>(periods);
    next_deadline_ += periods * period_;
  }
  const timespec deadline = to_timespec(next_deadline_);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
  }
  return 1e6 * (monotonic_time() - next_deadline_);
}

}  // namespace surefoot
