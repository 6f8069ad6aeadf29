// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

/// How long an old command may live. One table, used everywhere.
constexpr double kHoldTime = 0.010;   ///< [s] the last good command is repeated at most this long
constexpr double kStaleTime = 0.020;  ///< [s] of silence after which damping is latched
constexpr double kRobotWatchdogTime =
    0.100;  ///< [s] without running: robots damp by themselves, and so do we

}  // namespace surefoot
