// SPDX-License-Identifier: BSD-3-Clause
// Time functions of the C library on the shared clock. The library is preloaded (LD_PRELOAD) into
// the unmodified executables.
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "stall_tolerant_clock.hpp"

namespace {

using stall_tolerant_clock::Time;

constexpr Time kSecond = 1'000'000'000;
constexpr Time kPollPeriod = 100'000;  // [ns] between checks of a held clock

Time to_time(const timespec& value) { return kSecond * value.tv_sec + value.tv_nsec; }

timespec to_timespec(Time value) {
  value = std::max<Time>(value, 0);
  return {static_cast<time_t>(value / kSecond), static_cast<long>(value % kSecond)};
}

template <class Function>
Function* original(const char* name, const char* version = nullptr) {
  void* found = version == nullptr ? nullptr : dlvsym(RTLD_NEXT, name, version);
  // Other machines than x86-64 have another version of the symbol.
  if (found == nullptr) found = dlsym(RTLD_NEXT, name);
  return reinterpret_cast<Function*>(found);
}

int system_sleep(Time time) {
  static auto* const call = original<decltype(clock_nanosleep)>("clock_nanosleep");
  const timespec rest = to_timespec(time);
  return call(CLOCK_MONOTONIC, 0, &rest, nullptr);
}

// Sleep until `due` on the shared clock. @return 0 or an error number such as EINTR
int sleep_until(Time due) {
  stall_tolerant_clock::announce_sleep(due);
  bool slept = false;
  for (Time rest = due - stall_tolerant_clock::now(); rest > 0;
       rest = due - stall_tolerant_clock::now()) {
    const int problem = system_sleep(slept ? std::max(rest, kPollPeriod) : rest);
    if (problem != 0) return problem;
    slept = true;
  }
  return 0;
}

// Convert a deadline on the shared clock to the system's clock.
timespec to_system_deadline(const timespec& deadline) {
  return to_timespec(to_time(deadline) + stall_tolerant_clock::held());
}

// Return whether a deadline is on the monotonic clock, which counts from boot. The wall clock
// counts from 1970.
bool is_monotonic(const timespec& deadline) { return deadline.tv_sec < 1'000'000'000; }

// Shift the kernel's time stamps of datagrams. Programs subtract them from the wall clock, which is
// not held, so the difference must be the age on the shared clock.
void shift_timestamps(msghdr& message) {
  for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c)) {
    if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec stamp{}, wall{};
    std::memcpy(&stamp, CMSG_DATA(c), sizeof(stamp));
    clock_gettime(CLOCK_REALTIME, &wall);
    const Time age = std::max<Time>(to_time(wall) - to_time(stamp), 0);
    const Time came =
        stall_tolerant_clock::shared_time_at(stall_tolerant_clock::system_time() - age);
    stamp = to_timespec(to_time(wall) - (stall_tolerant_clock::now() - came));
    std::memcpy(CMSG_DATA(c), &stamp, sizeof(stamp));
  }
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* found) noexcept {
  static auto* const call = original<decltype(clock_gettime)>("clock_gettime");
  if (clock != CLOCK_MONOTONIC || !stall_tolerant_clock::is_shared()) return call(clock, found);
  *found = to_timespec(stall_tolerant_clock::now());
  return 0;
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* wanted, timespec* rest) {
  static auto* const call = original<decltype(clock_nanosleep)>("clock_nanosleep");
  if (clock != CLOCK_MONOTONIC || !stall_tolerant_clock::is_shared())
    return call(clock, flags, wanted, rest);
  const bool absolute = (flags & TIMER_ABSTIME) != 0;
  const Time due = to_time(*wanted) + (absolute ? 0 : stall_tolerant_clock::now());
  const int problem = sleep_until(due);
  if (problem == EINTR && !absolute && rest != nullptr)
    *rest = to_timespec(due - stall_tolerant_clock::now());
  return problem;
}

int nanosleep(const timespec* wanted, timespec* rest) {
  const int problem = clock_nanosleep(CLOCK_MONOTONIC, 0, wanted, rest);
  if (problem != 0) errno = problem;
  return problem == 0 ? 0 : -1;
}

int usleep(useconds_t microseconds) {
  const timespec wanted = to_timespec(1000 * static_cast<Time>(microseconds));
  return nanosleep(&wanted, nullptr);
}

int sem_clockwait(sem_t* semaphore, clockid_t clock, const timespec* deadline) {
  static auto* const call = original<decltype(sem_clockwait)>("sem_clockwait");
  if (clock != CLOCK_MONOTONIC || !stall_tolerant_clock::is_shared())
    return call(semaphore, clock, deadline);
  const timespec later = to_system_deadline(*deadline);
  return call(semaphore, clock, &later);
}

int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const timespec* deadline) {
  static auto* const call = original<decltype(pthread_cond_clockwait)>("pthread_cond_clockwait");
  if (clock != CLOCK_MONOTONIC || !stall_tolerant_clock::is_shared()) {
    return call(condition, mutex, clock, deadline);
  }
  const timespec later = to_system_deadline(*deadline);
  return call(condition, mutex, clock, &later);
}

int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                           const timespec* deadline) {
  static auto* const call =
      original<decltype(pthread_cond_timedwait)>("pthread_cond_timedwait", "GLIBC_2.3.2");
  if (!stall_tolerant_clock::is_shared() || !is_monotonic(*deadline))
    return call(condition, mutex, deadline);
  const timespec later = to_system_deadline(*deadline);
  return call(condition, mutex, &later);
}

ssize_t recvmsg(int socket, msghdr* message, int flags) {
  static auto* const call = original<decltype(recvmsg)>("recvmsg");
  const ssize_t got = call(socket, message, flags);
  if (got >= 0 && stall_tolerant_clock::is_shared()) shift_timestamps(*message);
  return got;
}

}  // extern "C"
