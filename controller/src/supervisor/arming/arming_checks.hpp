// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/arming.hpp"
#include "surefoot/fault.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// Limits of the arming checks.
struct ArmingLimits {
  // [s] Time for which all checks must pass; same default as in SupervisorOptions.
  double time = 1.0;
  // [deg C] Motors must be cooler than this; same default as temperature_warning in
  // SupervisorOptions.
  double temperature = 60.0;
  // [rad] Distance that joints must keep from their limits. Negative: joints may exceed their
  // limits by this amount.
  double joint_margin = 0.0;
  // Largest holding torque of the rise plan, as a share of tau_max; must be below 1.
  double max_holding_share = 0.0;
};

/// Write value and limit into a check. The check passes if value < limit. A NaN value fails.
inline void check_below(ArmingCheck& check, double value, double limit) noexcept {
  check.value = value;
  check.limit = limit;
  check.passed = value < limit;
}

/// Runs the arming checks on every LowState. The checks concern the link, motors, IMU, joints, feet
/// and rise plan, and whether a fault or another program keeps the robot down. The robot is ready
/// once all checks have passed for ArmingLimits::time without interruption. Real-time: all
/// functions except the constructor.
class ArmingChecks {
 public:
  ArmingChecks(const Robot& robot, const ArmingLimits& limits);

  /// Check a sample. @param step [s] time since the previous sample
  void update(const LowState& state, double step) noexcept;
  /// Add the numbers of samples that the link has received and missed since the last call. Without
  /// this call, update() derives these numbers from the steps of LowState::tick.
  void add_link_counts(double received, double missing) noexcept;
  bool has_link_counts() const noexcept { return has_link_counts_; }
  /// Count a call without a new sample, or with an implausible tick.
  void count_missed() noexcept;
  /// Set the fault that keeps the robot down, or kNone. The next update() takes it into account.
  void set_blocking_fault(FaultId why) noexcept;
  /// Set whether another program commands the robot, or a second robot sends LowStates.
  void set_conflict(bool present) noexcept;
  bool has_conflict() const noexcept { return !report_[ArmingCheckId::kConflict].passed; }
  /// Restart the time for which all checks must pass.
  void clear_ready() noexcept { report_.passed_for = 0.0, report_.ready = false; }
  /// Return the share of missing samples, 0 .. 1, averaged over about a second.
  double loss() const noexcept { return missing_ / (received_ + missing_ + 1e-9); }
  const ArmingReport& report() const noexcept { return report_; }

 private:
  ArmingCheck& at(ArmingCheckId id) noexcept { return report_.checks[static_cast<int>(id)]; }
  void count_link(double step) noexcept;
  void check_motors(const LowState& state) noexcept;
  void check_imu(const LowState& state, double step) noexcept;
  void check_joints(const LowState& state) noexcept;
  void check_order(const LowState& state) noexcept;
  void check_feet(const LowState& state) noexcept;
  void update_ready(double step) noexcept;

  Robot robot_;
  ArmingLimits limits_;
  ArmingReport report_;
  Vector3 gyro_ = Vector3::Zero(),
          accelerometer_ = Vector3::Zero();  // [rad/s], [m/s^2] low-passed with kImuFilterTime
  bool started_ = false;
  double period_ = 0.0;                    // [s] estimated period of the samples, see count_link()
  double received_ = 0.0, missing_ = 0.0;  // numbers of samples, decaying with kLossTime
  bool has_link_counts_ = false;           // set by add_link_counts()
};

}  // namespace surefoot
