// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// A clock that several programs share and that waits for whichever of them is late.
///
/// Machines that run tests stand still for tens of milliseconds, all at once or a processor of
/// them. A controller then damps, as it should, and a test of something else fails. This clock
/// follows CLOCK_MONOTONIC, but never by more than kMaxLead past the time at which one of the loops
/// that keep real time was to wake. To those loops such a machine looks like a good one.
///
/// So does one on which they are too slow themselves: what a loop computes takes no time here,
/// however long it takes. Whether loops fit their periods is for tests on the system's clock
/// (test_real_time.py).
namespace stall_tolerant_clock {

/// [ns]
using Time = std::int64_t;

inline constexpr Time kMillisecond = 1'000'000;

/// Sleeps up to this keep a loop's time; longer ones are somebody's leisure. [ns]
inline constexpr Time kLongestPeriod = 12 * kMillisecond;

/// How far the clock goes past the time at which a loop was to wake. [ns]
inline constexpr Time kMaxLead = 3 * kMillisecond;

/// As often it looks whether the one it waits for still lives. [ns]
inline constexpr Time kAliveCheckPeriod = 20 * kMillisecond;

/// For how long it waits for a thread that lives, which may have something else to do. [ns]
inline constexpr Time kMaxWait = 500 * kMillisecond;

/// Is there a clock to share? It is in the file that STALL_TOLERANT_CLOCK names.
bool is_shared() noexcept;

/// The shared time, which the system's was at `real`; [ns] on CLOCK_MONOTONIC both.
Time shared_time_at(Time real) noexcept;

/// The shared time now. [ns]
Time now() noexcept;

/// By how much it is behind the system's. [ns]
Time held() noexcept;

/// The calling thread is about to sleep until `due` and is waited for, unless it is longer than
/// kLongestPeriod. [ns]
void announce_sleep(Time due) noexcept;

/// The system's CLOCK_MONOTONIC. [ns]
Time system_time() noexcept;

}  // namespace stall_tolerant_clock
