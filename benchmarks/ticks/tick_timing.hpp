// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "call_timing.hpp"
#include "replay_controller.hpp"

namespace bench {

/// Time update() of the replaying controller, LowState to LowCmd.
Series time_ticks(const ReplayPlan& plan);

/// Time update() at the rate of the LowStates, in one pass over at most the first 500 LowStates.
/// The thread sleeps between ticks, so that other processes use the caches.
Series time_paced_ticks(const ReplayPlan& plan);

/// Time WholeBodyController::update(), state to torque, on the estimated states and the references
/// of the replaying controller.
Series time_state_to_torque(const ReplayPlan& plan);

/// Time the stages of a tick, with one series per stage; the clock is read at each change of stage.
std::vector<Series> time_stages(const ReplayPlan& plan);

/// Time an empty busy loop that lasts about as long as a tick. The longest times of this series
/// show the jitter of the machine.
/// @param length duration of the loop [us]
Series time_null(const ReplayPlan& plan, double length);

}  // namespace bench
