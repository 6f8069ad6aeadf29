// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/alternation.hpp"
#include "supervisor/faults/debounce.hpp"
#include "supervisor/faults/fault_log.hpp"
#include "surefoot/safety.hpp"

namespace surefoot {

/// What is wrong with the motors by their own reports: mode, torque against what they were told,
/// temperature, angle. Real-time: yes.
class MotorFaults {
 public:
  /// @param warning, stop [deg C] torque is derated from one on, and the robot sits at the other
  /// @param joint_margin [rad] inside the limits; negative: beyond
  MotorFaults(const Robot& robot, double warning, double stop, double joint_margin)
      : robot_(robot),
        safety_(robot),
        temperature_warning_(warning),
        temperature_stop_(stop),
        joint_margin_(joint_margin) {}

  /// Judge a report. @param dt [s] @param lost_leg of which temperatures alone are looked at,
  /// -1: none @param log is told
  void update(const LowState& state, double dt, int lost_leg, FaultLog& log) noexcept;
  /// What the motors have just been told: compared with what they report from now on.
  void record_command(const LowCmd& command, const LowState& state) noexcept;
  /// Something else than record_command() has left since: torques go to and fro for it.
  void skip_command() noexcept {
    for (int i = 0; i < kMotors; ++i)
      commanded_alternation_[i].interrupt(), measured_alternation_[i].interrupt();
  }
  /// Share of each motor's torque that its temperature leaves it, kLeastShare .. 1.
  const Vector12& torque_share() const noexcept { return torque_share_; }
  /// Forget torques and counts, not temperatures.
  void reset() noexcept;

  static constexpr double kLeastShare = 0.5;

 private:
  void judge_modes(const LowState& state, int lost_leg, FaultLog& log) noexcept;
  void judge_torques(const LowState& state, double dt, int lost_leg, FaultLog& log) noexcept;
  int count_alternating_legs(const LowState& state, double dt, int lost_leg) noexcept;
  void judge_temperatures(const LowState& state, double dt, FaultLog& log) noexcept;
  void judge_angles(const LowState& state, int lost_leg, FaultLog& log) noexcept;

  Robot robot_;
  Safety safety_;  // its position protection
  double temperature_warning_, temperature_stop_, joint_margin_;
  Vector12 commanded_ = Vector12::Zero();   // [N.m] by the last command
  Vector12 expected_ = Vector12::Zero();    // [N.m] told, smoothed
  Vector12 measured_ = Vector12::Zero();    // [N.m] tauEst, smoothed
  Vector12 idle_share_ = Vector12::Zero();  // share of reports in which there was none of it
  std::array<Alternation, kMotors> commanded_alternation_, measured_alternation_;
  Vector12 temperature_ = Vector12::Zero();  // [deg C] smoothed
  Vector12 torque_share_ = Vector12::Ones();
  std::array<Debounce, kMotors> deviating_;
  Debounce overheated_;
  int bad_modes_ = 0, bad_angles_ = 0;  // reports in a row
  bool started_ = false;
};

}  // namespace surefoot
