// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/alternation.hpp"
#include "supervisor/faults/debounce.hpp"
#include "supervisor/faults/fault_log.hpp"
#include "surefoot/safety.hpp"

namespace surefoot {

/// Detects motor faults from the motors' own measurements: mode, torque against the last command,
/// temperature and angle.
///
/// Commanded and measured torques pass the same filter. A motor is weak (kMotorWeak) if for 50 ms
/// its mean torque is outside the tolerance or it is idle. If motors of several legs are weak, or
/// torques of several legs alternate, another program commands the robot (kOverridden). Real-time:
/// yes.
class MotorFaults {
 public:
  /// @param warning [deg C] temperature from which torques are derated
  /// @param stop [deg C] temperature from which the robot sits down
  /// @param joint_margin [rad] kept from the joint limits; negative: tolerance beyond them
  MotorFaults(const Robot& robot, double warning, double stop, double joint_margin)
      : robot_(robot),
        safety_(robot),
        temperature_warning_(warning),
        temperature_stop_(stop),
        joint_margin_(joint_margin) {}

  /// Judge a sample.
  /// @param dt [s] since the last call
  /// @param lost_leg leg of which only temperatures are judged, or -1
  /// @param log receives the faults
  void update(const LowState& state, double dt, int lost_leg, FaultLog& log) noexcept;
  /// Record the command just sent; later torque measurements are compared with it.
  /// @param state sample for which the command was computed; its dq gives the damping torque
  void record_command(const LowCmd& command, const LowState& state) noexcept;
  /// Exclude the next sample from the alternation measures, because the command just sent was not
  /// passed to record_command().
  void skip_command() noexcept {
    for (int i = 0; i < kMotors; ++i)
      commanded_alternation_[i].interrupt(), measured_alternation_[i].interrupt();
  }
  /// Return the share of each motor's torque limit that is allowed at its temperature, kLeastShare
  /// .. 1, SDK motor order.
  const Vector12& torque_share() const noexcept { return torque_share_; }
  /// Forget torques and counts, but not temperatures.
  void reset() noexcept;

  /// Share of the torque limits that is left at temperature_stop. Chosen. Must be below 1, so that
  /// motors cool. Must exceed `RisePlan::torque_share`, so that the robot can hold itself while it
  /// sits down.
  static constexpr double kLeastShare = 0.5;

 private:
  void judge_modes(const LowState& state, int lost_leg, FaultLog& log) noexcept;
  void judge_torques(const LowState& state, double dt, int lost_leg, FaultLog& log) noexcept;
  int count_alternating_legs(const LowState& state, double dt, int lost_leg) noexcept;
  void judge_temperatures(const LowState& state, double dt, FaultLog& log) noexcept;
  void judge_angles(const LowState& state, int lost_leg, FaultLog& log) noexcept;

  Robot robot_;
  Safety safety_;  // for position_protect()
  double temperature_warning_, temperature_stop_, joint_margin_;
  Vector12 commanded_ = Vector12::Zero();   // [N.m] torques of the last command, damping included
  Vector12 expected_ = Vector12::Zero();    // [N.m] commanded_, low-pass filtered
  Vector12 measured_ = Vector12::Zero();    // [N.m] tauEst, low-pass filtered
  Vector12 idle_share_ = Vector12::Zero();  // share of samples in which a motor was idle
  std::array<Alternation, kMotors> commanded_alternation_, measured_alternation_;
  Vector12 temperature_ = Vector12::Zero();  // [deg C] low-pass filtered
  Vector12 torque_share_ = Vector12::Ones();
  std::array<Debounce, kMotors> deviating_;
  Debounce overheated_;
  int bad_modes_ = 0, bad_angles_ = 0;  // numbers of consecutive bad samples
  bool started_ = false;
};

}  // namespace surefoot
