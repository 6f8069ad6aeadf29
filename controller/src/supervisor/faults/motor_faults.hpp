// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/alternation.hpp"
#include "supervisor/faults/debounce.hpp"
#include "supervisor/faults/fault_log.hpp"
#include "surefoot/safety.hpp"

namespace surefoot {

/// Detects motor faults from the motors' own measurements: mode, torque (compared with the last
/// command), temperature and angle.
///
/// Commanded and measured torques pass the same low-pass. A motor is weak (kMotorWeak) if, for 50
/// ms, its mean torque differs too much from the mean command, or it gives hardly any torque in
/// most samples. If motors of several legs are weak, or torques of several legs alternate, another
/// program also commands the robot (kOverridden). Real-time: yes.
class MotorFaults {
 public:
  /// @param warning [deg C] temperature above which torques are reduced
  /// @param stop [deg C] temperature from which the robot sits down
  /// @param joint_margin [rad] distance to keep from the joint limits; negative: joints may exceed
  ///   their limits by this amount
  MotorFaults(const Robot& robot, double warning, double stop, double joint_margin)
      : robot_(robot),
        safety_(robot),
        temperature_warning_(warning),
        temperature_stop_(stop),
        joint_margin_(joint_margin) {}

  /// Check a sample.
  /// @param dt [s] time since the last call
  /// @param lost_leg leg whose motors are checked only for temperature, or -1
  /// @param log receives the faults
  void update(const LowState& state, double dt, int lost_leg, FaultLog& log) noexcept;
  /// Record the command that was sent. Later torque measurements are compared with this command.
  /// @param state sample for which the command was computed; its dq gives the damping torque
  void record_command(const LowCmd& command, const LowState& state) noexcept;
  /// Do not count an alternation in the next sample. Call this in a tick whose command is not
  /// passed to record_command().
  void skip_command() noexcept {
    for (int i = 0; i < kMotors; ++i)
      commanded_alternation_[i].interrupt(), measured_alternation_[i].interrupt();
  }
  /// Return the share of each motor's torque limit that is allowed at its temperature, SDK motor
  /// order, from kMinTorqueShare to 1.
  const Vector12& torque_share() const noexcept { return torque_share_; }
  /// Clear torques and counts, but not temperatures.
  void reset() noexcept;

  /// Share of the torque limits that remains at temperature_stop. Chosen below 1, so that motors
  /// cool, and above the largest holding torque of RisePlan, so that the robot can hold itself
  /// while it sits down.
  static constexpr double kMinTorqueShare = 0.5;

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
  Vector12 expected_ = Vector12::Zero();    // [N.m] commanded_, low-passed
  Vector12 measured_ = Vector12::Zero();    // [N.m] tauEst, low-passed
  Vector12 idle_share_ = Vector12::Zero();  // share of samples in which each motor was idle
  std::array<Alternation, kMotors> commanded_alternation_, measured_alternation_;
  Vector12 temperature_ = Vector12::Zero();  // [deg C] low-passed
  Vector12 torque_share_ = Vector12::Ones();
  std::array<Debounce, kMotors> deviating_;
  Debounce overheated_;
  int bad_modes_ = 0, bad_angles_ = 0;  // numbers of consecutive bad samples
  bool started_ = false;
};

}  // namespace surefoot
