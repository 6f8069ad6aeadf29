// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reference/stand_reference.hpp"
#include "reference/usable_friction.hpp"
#include "safety/command_hold.hpp"
#include "safety/fallback_chain.hpp"
#include "safety/tick_clock.hpp"
#include "safety/torque_command.hpp"
#include "stand/delay_predictor.hpp"
#include "stand/gain_change_ramp.hpp"
#include "stand/sensor_check.hpp"
#include "surefoot/stand_controller.hpp"
#include "surefoot/state_estimator.hpp"
#include "surefoot/whole_body_controller.hpp"

namespace surefoot {

/// Components of the StandController, and its tick: estimate the state from a LowState, update the
/// reference, solve the QP, limit the torques, and choose the LowCmd to send.
struct StandController::Impl {
  Impl(const Robot& r, const Gains& g, const StandOptions& o);

  const LowCmd& tick(const LowState& low_state) noexcept;
  void apply_gains(const Gains& gains) noexcept;

  Robot robot;
  StandOptions options;
  TickClock clock;
  StateEstimator estimator;
  SensorCheck sensor_check;
  StandReference reference;
  UsableFriction friction;
  DelayPredictor predictor;
  Dynamics predicted_dynamics;  // at the predicted state; used only if StandOptions::delay > 0
  // Estimated state; state.friction is the share of the friction that the QP may use.
  RobotState state;
  WholeBodyController controller;
  FallbackChain fallback_chain;
  TorqueCommand torque_command;
  CommandHold command_hold;
  GainChangeRamp gain_ramp;
  double time_since_estimate = 0.0;  // [s] time since the last good estimate
  int pose_latches = 0;              // number of ticks that have latched the pose
  Status status = Status::kWaiting;
  Status fault = Status::kOk;
  FallbackLevel fallback_level = FallbackLevel::kDamping;
  std::array<std::uint64_t, kFallbackLevels> fallback_counts{};

 private:
  Status estimate_and_solve(const LowState& low_state, double dt) noexcept;
  Status solve_predicted(const Reference& desired, double dt) noexcept;
  Status solve(const Dynamics& dynamics, const RobotState& used_state,
               const Reference& desired) noexcept;
  void compute_fallback(const Dynamics& dynamics, const RobotState& used_state,
                        const Reference& desired) noexcept;
  const LowCmd& select_command(Status tick, double elapsed) noexcept;
};

}  // namespace surefoot
