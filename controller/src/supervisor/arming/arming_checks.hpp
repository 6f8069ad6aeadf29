// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/arming.hpp"
#include "surefoot/fault.hpp"
#include "surefoot/low_level.hpp"
#include "surefoot/robot.hpp"

namespace surefoot {

/// What the checks are held against.
struct ArmingLimits {
  double time = 1.0;          // [s] that all must pass
  double temperature = 60.0;  // [deg C]
  double joint_margin = 0.0;  // [rad] inside the limits
  double torque_share = 0.0;  // of tau_max that the plan takes; below 1 it is feasible
};

/// Write into a check what was found, and whether that is below the limit; NaN is not.
inline void check_below(ArmingCheck& check, double value, double limit) noexcept {
  check.value = value;
  check.limit = limit;
  check.passed = value < limit;
}

/// Runs the arming checks on every LowState. Real-time: update(), count_missed().
class ArmingChecks {
 public:
  ArmingChecks(const Robot& robot, const ArmingLimits& limits);

  /// Judge a report. @param step [s] since the one before
  void update(const LowState& state, double step) noexcept;
  /// What a link has counted since the last call; from then on these count, not the steps.
  void add_link_counts(double received, double missing) noexcept;
  bool has_link_counts() const noexcept { return has_link_counts_; }
  /// A call that brought no new report, or an impossible one.
  void count_missed() noexcept;
  /// What keeps the robot down, or kNone; from the next update() on.
  void set_blocking_fault(FaultId why) noexcept;
  /// The report just judged is no good for reasons of its own.
  void clear_ready() noexcept { report_.passed_for = 0.0, report_.ready = false; }
  /// Share of the reports of the last second or so that are missing.
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
  Vector3 gyro_ = Vector3::Zero(), accelerometer_ = Vector3::Zero();  // noise averaged out
  bool started_ = false;
  double period_ = 0.0;                    // [s] between reports, the shortest of late
  double received_ = 0.0, missing_ = 0.0;  // reports of the last second or so
  bool has_link_counts_ = false;           // by add_link_counts()
};

}  // namespace surefoot
