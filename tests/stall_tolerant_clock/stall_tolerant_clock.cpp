// SPDX-License-Identifier: BSD-3-Clause
#include "stall_tolerant_clock.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace stall_tolerant_clock {

namespace {

constexpr int kLoops = 64;
constexpr unsigned kHolds = 1024;

// A thread that runs a periodic loop in real time.
struct Loop {
  std::atomic<int> thread;  // 0: free slot
  std::atomic<int> process;
  std::atomic<Time> due;     // wake-up time on the shared clock; 0: the clock does not wait for it
  std::atomic<Time> waited;  // how long the clock has waited since then
};

// A period in which the clock stood still. It ended at `real` on the system's clock; the shared
// clock was `held` behind by then.
struct Hold {
  std::atomic<Time> real, held;
};

// Contents of the shared file. A new file has zeros, which is the initial state. paused_process.py
// also writes `exempt_process`.
struct SharedState {
  std::atomic<Time> held;
  std::atomic<Time> exempt_process;  // process that the clock does not wait for
  std::atomic<Time> latest;          // latest time that a thread has received
  std::atomic<unsigned> holds;
  Hold history[kHolds];
  Loop loops[kLoops];
};

static_assert(offsetof(SharedState, exempt_process) == 8, "paused_process.py writes it there");

SharedState* map_file() noexcept {
  const char* path = std::getenv("STALL_TOLERANT_CLOCK");
  if (path == nullptr) return nullptr;
  const int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0 || ftruncate(file, sizeof(SharedState)) != 0) return nullptr;
  void* place = mmap(nullptr, sizeof(SharedState), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return place == MAP_FAILED ? nullptr : static_cast<SharedState*>(place);
}

SharedState* shared() noexcept {
  static SharedState* const mapped = map_file();
  return mapped;
}

// The slot of this thread. It is free again when the thread ends.
struct LoopSlot {
  Loop* loop = nullptr;
  int thread = 0;

  ~LoopSlot() { leave(); }

  bool owned() const noexcept { return loop != nullptr && loop->thread.load() == thread; }

  void leave() noexcept {
    if (owned()) {
      loop->due.store(0);
      loop->thread.store(0);
    }
    loop = nullptr;
  }

  void take() noexcept {
    if (owned()) return;  // wait_for() may have freed the slot meanwhile
    thread = static_cast<int>(syscall(SYS_gettid));
    for (Loop& candidate : shared()->loops) {
      int nobody = 0;
      if (!candidate.thread.compare_exchange_strong(nobody, thread)) continue;
      candidate.due.store(0);  // the clock does not wait for it yet
      candidate.process.store(getpid());
      loop = &candidate;
      return;
    }
  }
};
thread_local LoopSlot place;

// Return the loop with the earliest wake-up time; null: the clock waits for no loop.
Loop* slowest() noexcept {
  Loop* found = nullptr;
  const Time exempt_process = shared()->exempt_process.load();
  for (Loop& loop : shared()->loops) {
    if (loop.thread.load() == 0 || loop.due.load() == 0) continue;
    if (loop.process.load() == exempt_process) {
      loop.due.store(0);  // until its next sleep
      continue;
    }
    if (found == nullptr || loop.due.load() < found->due.load()) found = &loop;
  }
  return found;
}

// PF_EXITING of the kernel's sched.h. A large process that was killed takes some hundred
// milliseconds to free its memory, and its state is still "running" meanwhile.
constexpr unsigned kExiting = 0x4;

bool is_alive(int process, int thread) noexcept {
  const int error = errno;  // clock_gettime() must not change it
  char path[64], text[512] = {};
  std::snprintf(path, sizeof(path), "/proc/%d/task/%d/stat", process, thread);
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  const bool unreadable = file < 0 && errno != ENOENT && errno != ESRCH;  // the thread may be alive
  const ssize_t got = file < 0 ? -1 : read(file, text, sizeof(text) - 1);
  if (file >= 0) close(file);
  if (unreadable) {
    errno = error;
    return true;
  }
  // pid (name) state ppid pgrp session tty_nr tpgid flags ...; see proc_pid_stat(5)
  const char* name_end = got > 0 ? std::strrchr(text, ')') : nullptr;
  char state = 'X';
  unsigned flags = 0;
  const int read_fields =
      name_end == nullptr ? 0
                          : std::sscanf(name_end + 2, "%c %*d %*d %*d %*d %*d %u", &state, &flags);
  errno = error;
  return read_fields == 2 && state != 'Z' && state != 'X' && (flags & kExiting) == 0;
}

// Count the time waited for a loop. Free its slot if the thread is gone, or after kMaxWait.
void wait_for(Loop& loop, Time more) noexcept {
  int thread = loop.thread.load();
  const Time before = loop.waited.fetch_add(more), after = before + more;
  const bool doubtful = before / kAliveCheckPeriod != after / kAliveCheckPeriod;
  const bool gone = doubtful && !is_alive(loop.process.load(), thread);
  if (!gone && after <= kMaxWait) return;
  loop.thread.compare_exchange_strong(thread, 0);  // unless another thread has the slot by now
}

// Hold the clock by `more`. @return false if another thread has changed it first
bool hold(Loop& loop, Time real, Time before, Time more) noexcept {
  if (!shared()->held.compare_exchange_strong(before, before + more)) return false;
  const unsigned holds = shared()->holds.load();
  const Hold& last = shared()->history[(holds + kHolds - 1) % kHolds];
  const bool goes_on = holds > 0 && last.real.load() - last.held.load() == real - before - more;
  Hold& entry = shared()->history[(goes_on ? holds - 1 : shared()->holds.fetch_add(1)) % kHolds];
  entry.held.store(before + more);
  entry.real.store(real);
  wait_for(loop, more);
  return true;
}

}  // namespace

bool is_shared() noexcept { return shared() != nullptr; }

Time system_time() noexcept {
  static const auto call =
      reinterpret_cast<int (*)(clockid_t, timespec*)>(dlsym(RTLD_NEXT, "clock_gettime"));
  timespec found{};
  call(CLOCK_MONOTONIC, &found);
  return 1'000'000'000 * static_cast<Time>(found.tv_sec) + found.tv_nsec;
}

Time held() noexcept { return shared()->held.load(); }

Time now() noexcept {
  Time time = 0;
  while (true) {
    const Time before = held();
    const Time real = system_time();
    time = real - before;
    Loop* const loop = slowest();
    if (held() != before) continue;  // another thread has held it meanwhile
    if (loop == nullptr) break;
    // Do not go back behind a time that a thread has received.
    const Time most = std::max(loop->due.load() + kMaxLead, shared()->latest.load());
    if (time <= most) break;
    if (hold(*loop, real, before, time - most)) {
      time = most;
      break;
    }
  }
  Time latest = shared()->latest.load();
  while (latest < time && !shared()->latest.compare_exchange_weak(latest, time)) {
  }
  return std::max(latest, time);  // never goes back
}

Time shared_time_at(Time real) noexcept {
  const unsigned holds = shared()->holds.load();
  const Time most = now();
  Time behind = 0, time = most;
  for (unsigned k = holds > kHolds ? holds - kHolds : 0; k < holds; ++k) {
    const Hold& entry = shared()->history[k % kHolds];
    if (entry.real.load() > real) {  // the clock stood still then, or was before this hold
      time = std::min(time, entry.real.load() - entry.held.load());
    } else {
      behind = std::max(behind, entry.held.load());
    }
  }
  return std::min(time, real - behind);
}

void announce_sleep(Time due) noexcept {
  const Time time = now();
  if (due - time > kLongestPeriod) {
    place.leave();
    return;
  }
  place.take();
  if (place.loop == nullptr) return;
  place.loop->waited.store(0);
  place.loop->due.store(std::max(due, time));
}

}  // namespace stall_tolerant_clock
