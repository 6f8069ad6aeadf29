// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace surefoot {

/// Return the time [s] of CLOCK_MONOTONIC, which never runs backwards. Real-time safe: yes.
inline double monotonic_time() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace surefoot
