// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

// Time limits on old commands and old samples. All parts of the controller use them.

/// [s] Longest time for which the last good command is repeated. Chosen. Longer than a cold solve
/// (5 ms) and than single lost samples. If larger: the robot falls meanwhile. Test:
/// test_fault_holds_the_command_for_10_ms_then_latches_damping.
constexpr double kHoldTime = 0.010;
/// [s] Time without a sample after which damping is latched. Chosen. Longer than kHoldTime, shorter
/// than kRobotWatchdogTime. Test: test_silent_robot_is_stale_within_60_ms_at_every_rate.
constexpr double kStaleTime = 0.020;
/// [s] Time without a command after which a robot damps by itself; the controller then damps too.
/// Assumed for the vendor's firmware; the virtual robot does the same (docs/faults.md).
constexpr double kRobotWatchdogTime = 0.100;

}  // namespace surefoot
