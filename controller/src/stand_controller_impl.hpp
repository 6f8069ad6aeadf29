// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "estimator/delay_predictor.hpp"
#include "reference/stand_reference.hpp"
#include "reference/usable_friction.hpp"
#include "safety/command_keeper.hpp"
#include "safety/command_ladder.hpp"
#include "safety/gain_ramp.hpp"
#include "safety/tick_clock.hpp"
#include "safety/torque_command.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/state_estimator.hpp"
#include "surefoot/whole_body_controller.hpp"

namespace surefoot {

/// The whole tick, from a report to a command.
struct StandController::Impl {
  Impl(const Robot& r, const Gains& g, const StandOptions& o);

  const LowCmd& tick(const LowState& low_state) noexcept;
  void adopt(const Gains& gains) noexcept;

  Robot robot;
  StandOptions options;
  TickClock clock;
  StateEstimator estimator;
  StandReference reference;
  UsableFriction friction;
  DelayPredictor predictor;
  Dynamics predicted;  // at the state when the command acts
  RobotState state;    // as estimated, but for the friction: what may be used of it
  WholeBodyController controller;
  CommandLadder ladder;
  TorqueCommand torques;
  CommandKeeper keeper;
  GainRamp ramp;
  double since_estimate = 0.0;  // [s]
  int latches = 0;
  Status status = Status::kWaiting;
  Status fault = Status::kOk;
  Rung rung = Rung::kDamping;
  std::array<std::uint64_t, kRungs> rung_counts{};

 private:
  Status think(const LowState& low_state, double dt) noexcept;
  Status solve_predicted(const Reference& wanted, double dt) noexcept;
  Status solve(const Dynamics& dynamics, const RobotState& now, const Reference& wanted) noexcept;
  void descend(const Dynamics& dynamics, const RobotState& now, const Reference& wanted) noexcept;
  const LowCmd& send(Status tick, double elapsed) noexcept;
};

}  // namespace surefoot
