// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/faults/debounce.hpp"
#include "supervisor/faults/fault_log.hpp"
#include "surefoot/estimator_report.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// What the estimator thinks of its sensors and of the ground, as faults. Real-time: yes.
class EstimatorFaults {
 public:
  /// @param payload_limit [kg] more than it the robot is not to bear
  explicit EstimatorFaults(double payload_limit) : payload_limit_(payload_limit) {}

  /// Judge what a standing robot's estimator says. @param dt [s] @param log is told of all that
  /// nobody else looks at
  void update(const EstimatorReport& report, const RobotState& state, double dt,
              FaultLog& log) noexcept;
  /// There is no estimator at work. @param sitting what the robot sits down for is held: nothing
  /// says that it is over
  void reset(bool sitting, FaultLog& log) noexcept;

  /// Verdicts on the IMU, which ImuMonitor judges as well.
  bool gyroscope_bad() const noexcept { return gyroscope_bad_; }
  bool accelerometer_bad() const noexcept { return accelerometer_bad_; }
  bool quaternion_bad() const noexcept { return quaternion_bad_; }
  /// Has the estimator found what the robot sits down for?
  bool must_sit_down() const noexcept { return gyroscope_bad_ || overloaded_; }

 private:
  double payload_limit_;
  bool gyroscope_bad_ = false, accelerometer_bad_ = false, quaternion_bad_ = false;
  bool overloaded_ = false;
  Debounce gyroscope_, accelerometer_, quaternion_, slip_, lifted_, payload_;
};

}  // namespace surefoot
