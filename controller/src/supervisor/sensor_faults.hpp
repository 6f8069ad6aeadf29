// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/fault_log.hpp"
#include "surefoot/estimator_report.hpp"
#include "surefoot/types.hpp"

namespace surefoot {

/// What the estimator thinks of its sensors and of the ground, as faults. Real-time: yes.
class SensorFaults {
 public:
  /// @param payload_limit [kg] more than it the robot is not to bear
  explicit SensorFaults(double payload_limit) : payload_limit_(payload_limit) {}

  /// Judge what a standing robot's estimator says. @param dt [s] @param log is told
  void update(const EstimatorReport& report, const RobotState& state, double dt,
              FaultLog& log) noexcept;
  /// There is no estimator at work.
  void reset(FaultLog& log) noexcept;

 private:
  double payload_limit_;
  Lasting gyroscope_, accelerometer_, quaternion_, slip_, lifted_, payload_;
};

}  // namespace surefoot
