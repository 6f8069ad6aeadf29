// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/debounce.hpp"
#include "supervisor/faults/fault_log.hpp"
#include "surefoot/estimator_report.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// Turns the findings of a standing robot's estimator into faults: sensor verdicts, slip, contact
/// and payload. Each finding must last for a minimum time before it is a fault. Exception: a bad
/// foot force is a fault at once, because its verdict already needs some time. Real-time: yes.
class EstimatorFaults {
 public:
  /// @param payload_limit [kg] a larger payload is a fault
  explicit EstimatorFaults(double payload_limit) : payload_limit_(payload_limit) {}

  /// Evaluate the report of the estimator of a robot that stands or walks.
  /// @param stepping whether the feet step; then no foot may touch the ground during a flight
  /// @param dt [s] time since the last call
  /// @param log receives kFootForce, kSlip, kLifted and kPayload. It does not receive the faults of
  ///   the IMU, which the functions below return
  void update(const EstimatorReport& report, const RobotState& state, bool stepping, double dt,
              FaultLog& log) noexcept;
  /// Clear all findings; call this while no estimator runs.
  /// @param sitting true if the robot sits down: keep the faults that make it sit down (gyroscope,
  ///   payload), because without an estimator nothing shows that they have ended
  void reset(bool sitting, FaultLog& log) noexcept;

  /// Return whether the estimator has found this sensor faulty. ImuMonitor also checks the IMU, in
  /// every mode.
  bool gyroscope_bad() const noexcept { return gyroscope_bad_; }
  bool accelerometer_bad() const noexcept { return accelerometer_bad_; }
  bool quaternion_bad() const noexcept { return quaternion_bad_; }
  /// Return whether the estimator has found a fault that makes the robot sit down.
  bool must_sit_down() const noexcept { return gyroscope_bad_ || overloaded_; }

 private:
  double payload_limit_;
  bool gyroscope_bad_ = false, accelerometer_bad_ = false, quaternion_bad_ = false;
  bool overloaded_ = false;
  Debounce gyroscope_, accelerometer_, quaternion_, slip_, lifted_, payload_;
};

}  // namespace surefoot
