// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <surefoot/stage_clock.hpp>
#include <surefoot/walk_controller.hpp>
#include <vector>

namespace bench {

/// LowStates and requests to replay, controller settings, and number of passes.
struct ReplayPlan {
  explicit ReplayPlan(surefoot::Robot r) : robot(std::move(r)) {}
  surefoot::Robot robot;
  surefoot::Gains gains;
  surefoot::QpForm form = surefoot::QpForm::kAuto;
  long passes = 1;     ///< number of timed passes over the LowStates, after one untimed pass
  long period = 2000;  ///< time between LowStates [us]
  std::vector<surefoot::LowState> low_states;
  std::vector<surefoot::BodyReference> references;  ///< one per LowState, or empty
  std::vector<surefoot::WalkVelocity> velocities;   ///< one per LowState; empty: the robot stands
  surefoot::Gait gait = surefoot::Gait::kAuto;      ///< used only with velocities
};

/// The controller of a plan: a WalkController if the plan has velocities, else a StandController.
class ReplayController {
 public:
  explicit ReplayController(const ReplayPlan& plan);

  void start() noexcept;                    ///< reset the controller for a pass from LowState 0 on
  void request(std::size_t tick) noexcept;  ///< set what was requested in a tick
  void update(std::size_t tick) noexcept { controller_->update(plan_.low_states[tick]); }
  const surefoot::StandController& get() const noexcept { return *controller_; }
  /// Whether the last tick was solved at the first attempt.
  bool solved() const noexcept;
  /// Whether the robot stepped in the last tick.
  bool walking() const noexcept { return controller_->reference().stepping; }

 private:
  const ReplayPlan& plan_;
  std::unique_ptr<surefoot::StandController> controller_;
  surefoot::WalkController* walk_ = nullptr;  // the same controller, if it walks
};

}  // namespace bench
