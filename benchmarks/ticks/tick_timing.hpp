// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <surefoot/stage_clock.hpp>
#include <surefoot/stand_controller.hpp>
#include <vector>

#include "call_timing.hpp"

namespace bench {

/// What is replayed, and how often.
struct ReplayPlan {
  explicit ReplayPlan(surefoot::Robot r) : robot(std::move(r)) {}
  surefoot::Robot robot;
  surefoot::Gains gains;
  surefoot::QpForm form = surefoot::QpForm::kAuto;
  long passes = 1;     ///< over the reports, after one that is not timed
  long period = 2000;  ///< from report to report [us]
  std::vector<surefoot::LowState> reports;
  std::vector<surefoot::BodyReference> references;  ///< told before each report; or none at all
};

/// StandController::update(): LowState to LowCmd.
Series time_ticks(const ReplayPlan& plan);

/// The same at the pace of the reports, asleep in between: others and the system have the caches
/// for that long. The first reports, once.
Series time_paced_ticks(const ReplayPlan& plan);

/// WholeBodyController::update(): state to torque, on the states that the estimator made of the
/// reports, with the references that the stand controller had.
Series time_state_to_torque(const ReplayPlan& plan);

/// The stages of a tick, each with a series of its own; their clock is read at every change.
std::vector<Series> time_stages(const ReplayPlan& plan);

/// A loop that computes nothing of use for about as long as a tick: what its tail shows is the
/// machine's. @param length [us]
Series time_null(const ReplayPlan& plan, double length);

}  // namespace bench
