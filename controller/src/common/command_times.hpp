// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

// Time limits of old commands and old samples, for all parts of the controller.

constexpr double kHoldTime = 0.010;   ///< [s] longest time that the last good command is repeated
constexpr double kStaleTime = 0.020;  ///< [s] without a sample, after which damping is latched
/// [s] without a command, after which a robot damps by itself; the controller then damps too.
constexpr double kRobotWatchdogTime = 0.100;

}  // namespace surefoot
