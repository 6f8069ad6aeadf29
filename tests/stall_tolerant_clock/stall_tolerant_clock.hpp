// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// A clock that several processes share and that waits for late loops.
///
/// Test machines stall for tens of milliseconds, completely or on single processors. A controller
/// then damps, as it should, and an unrelated test fails. This clock follows CLOCK_MONOTONIC, but
/// it stops kMaxLead after the wake-up time of the latest loop until that loop has woken. To the
/// loops, a stalled machine looks like a good one.
///
/// Limit: a machine that is too slow for the loops looks good as well, because computation takes no
/// time on this clock. Tests on the system's clock check whether loops meet their periods
/// (test_real_time.py).
namespace stall_tolerant_clock {

/// [ns]
using Time = std::int64_t;

inline constexpr Time kMillisecond = 1'000'000;

/// Longest sleep of a periodic loop; the clock does not wait for longer sleeps. [ns]
inline constexpr Time kLongestPeriod = 12 * kMillisecond;

/// How far the clock may pass the wake-up time of a loop. [ns]
inline constexpr Time kMaxLead = 3 * kMillisecond;

/// Period of the check whether the thread of a late loop is still alive. [ns]
inline constexpr Time kAliveCheckPeriod = 20 * kMillisecond;

/// Longest wait for a living thread, which may do something else by now. [ns]
inline constexpr Time kMaxWait = 500 * kMillisecond;

/// Return whether there is a shared clock: STALL_TOLERANT_CLOCK names its file.
bool is_shared() noexcept;

/// Convert a time of the system's CLOCK_MONOTONIC to the shared clock. [ns]
Time shared_time_at(Time real) noexcept;

/// Return the time on the shared clock. [ns]
Time now() noexcept;

/// Return how far the shared clock is behind the system's clock. [ns]
Time held() noexcept;

/// Announce that the calling thread sleeps until `due`, so that the clock waits for it. A sleep
/// longer than kLongestPeriod ends the waiting. [ns]
void announce_sleep(Time due) noexcept;

/// Return the system's CLOCK_MONOTONIC. [ns]
Time system_time() noexcept;

}  // namespace stall_tolerant_clock
