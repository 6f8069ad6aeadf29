// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reference/usable_friction.hpp"
#include "safety/command_hold.hpp"
#include "safety/fallback_chain.hpp"
#include "safety/tick_clock.hpp"
#include "safety/torque_command.hpp"
#include "surefoot/controller.hpp"
#include "surefoot/state_estimator.hpp"
#include "surefoot/whole_body_controller.hpp"
#include "tick/delay_predictor.hpp"
#include "tick/gain_change_ramp.hpp"
#include "tick/planned_reference.hpp"
#include "tick/sensor_check.hpp"

namespace surefoot {

/// Components of the Controller, and its tick: estimate the state from a LowState, plan the
/// reference, solve the QP, limit the torques, and choose the LowCmd to send.
struct Controller::Impl {
  Impl(const Robot& r, std::shared_ptr<Planner> p, const Gains& g, const ControllerOptions& o);

  const LowCmd& tick(const LowState& low_state) noexcept;
  void apply_gains(const Gains& gains) noexcept;

  Robot robot;
  ControllerOptions options;
  TickClock clock;
  StateEstimator estimator;
  SensorCheck sensor_check;
  PlannedReference planned;
  int lost_leg = -1;
  UsableFriction friction;
  DelayPredictor predictor;
  Dynamics predicted_dynamics;  // at the predicted state, see predict_and_solve()
  // Estimated state; state.friction is the share of the friction that the QP may use.
  RobotState state;
  WholeBodyController controller;
  FallbackChain fallback_chain;
  TorqueCommand torque_command;
  CommandHold command_hold;
  GainChangeRamp gain_ramp;
  double time_since_estimate = 0.0;  // [s] time since the last good estimate
  bool started = false;              // true if a tick since the start had a good estimate
  Status status = Status::kWaiting;
  Status fault = Status::kOk;
  FallbackLevel fallback_level = FallbackLevel::kDamping;
  std::array<std::uint64_t, kFallbackLevels> fallback_counts{};
  Eigen::VectorXd motion;  // of limited_motion(), shape (nv,)

 private:
  Status estimate_and_solve(const LowState& low_state, double dt) noexcept;
  Eigen::Vector4d usable_friction(const Dynamics& dynamics, const RobotState& used_state,
                                  double dt) noexcept;
  Status predict_and_solve(Status plan_status, double dt) noexcept;
  void hold_unloaded_feet(const Dynamics& dynamics, const RobotState& used_state) noexcept;
  Status solve(const Dynamics& dynamics, const RobotState& used_state, Status plan_status) noexcept;
  void compute_fallback(const Dynamics& dynamics, const RobotState& used_state) noexcept;
  const LowCmd& select_command(Status tick, double elapsed) noexcept;
  const Eigen::VectorXd& limited_motion(const LimitedTorques& sent) noexcept;
};

}  // namespace surefoot
