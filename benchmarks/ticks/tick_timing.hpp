// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <surefoot/stage_clock.hpp>
#include <surefoot/stand_controller.hpp>
#include <vector>

#include "call_timing.hpp"

namespace bench {

/// LowStates to replay, controller settings, and number of passes.
struct ReplayPlan {
  explicit ReplayPlan(surefoot::Robot r) : robot(std::move(r)) {}
  surefoot::Robot robot;
  surefoot::Gains gains;
  surefoot::QpForm form = surefoot::QpForm::kAuto;
  long passes = 1;     ///< number of timed passes over the LowStates, after one untimed pass
  long period = 2000;  ///< time between LowStates [us]
  std::vector<surefoot::LowState> low_states;
  std::vector<surefoot::BodyReference> references;  ///< one per LowState, or empty
};

/// Time StandController::update(), LowState to LowCmd.
Series time_ticks(const ReplayPlan& plan);

/// Time StandController::update() at the rate of the LowStates, in one pass over at most the first
/// 500 LowStates. The thread sleeps between ticks, so that other processes use the caches.
Series time_paced_ticks(const ReplayPlan& plan);

/// Time WholeBodyController::update(), state to torque, on the estimated states and the references
/// of the stand controller.
Series time_state_to_torque(const ReplayPlan& plan);

/// Time the stages of a tick, with one series per stage; the clock is read at each change of stage.
std::vector<Series> time_stages(const ReplayPlan& plan);

/// Time an empty busy loop that lasts about as long as a tick. The longest times of this series
/// show the jitter of the machine.
/// @param length duration of the loop [us]
Series time_null(const ReplayPlan& plan, double length);

}  // namespace bench
