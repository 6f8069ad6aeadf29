// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace surefoot {

// Time limits for old commands and old samples, used by all parts of the controller.

/// [s] Longest time for which the last good command is repeated. Chosen longer than a cold solve
/// (5 ms) and than the gap that one lost sample leaves (4 ms at 500 Hz). If larger: the robot falls
/// in the meantime. Test: test_fault_holds_the_command_for_10_ms_then_latches_damping.
constexpr double kHoldTime = 0.010;
/// [s] Time without a sample after which damping is latched. Chosen longer than kHoldTime, and
/// shorter than kRobotWatchdogTime. Test: test_silent_robot_is_stale_within_60_ms_at_every_rate
/// (its 60 ms include one tick at 100 Hz and delays of the machine).
constexpr double kStaleTime = 0.020;
/// [s] Time without a command after which a robot damps by itself. If the time between two good
/// samples is longer than this, or this process has stalled for longer, the robot has damped
/// already. So the controller then latches damping too. The value is assumed for the vendor's
/// firmware; the virtual robot has the same value (docs/reference/fault-injection.md).
constexpr double kRobotWatchdogTime = 0.100;

}  // namespace surefoot
