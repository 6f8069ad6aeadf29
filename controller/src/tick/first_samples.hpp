// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/state_estimator.hpp"

namespace surefoot {

/// Judges the samples of the first 0.1 s, while the robot still stands as it was put down.
///
/// A finding counts only if every sample since the first one has shown it. Real-time: yes.
class FirstSamples {
 public:
  explicit FirstSamples(const RobotConfig& config) : config_(config) {}

  /// Judge a sample; the parameters are those of SensorCheck::update().
  /// @return kOk, or the status that names the wrong sensor
  Status update(const LowState& low_state, Status estimated, const StateEstimator& estimator,
                double dt) noexcept;
  /// Return whether all samples so far show joint angles that are wrong, but for too short a time.
  bool suspects_joint_angles() const noexcept {
    return !done() && (joints_out_of_range_ || unsupported_);
  }
  bool done() const noexcept { return time_ >= kTime; }
  void reset() noexcept;

 private:
  // [s] Time after which the accelerometer is judged. Chosen. Longer than an impact of a foot, and
  // shorter than the 0.18 s in which a robot without support falls.
  static constexpr double kTime = 0.1;

  void judge_joints(const LowState& low_state, const Dynamics& dynamics) noexcept;
  void judge_accelerometer(const IMU& imu, const Dynamics& dynamics, double dt) noexcept;

  RobotConfig config_;
  double time_ = 0.0;
  Status implausible_ = Status::kOk;  // the sensor beyond its range in the first sample, or kOk
  double implausible_time_ = 0.0;     // [s] for which it has been beyond its range
  // Whether every sample so far has shown the finding.
  bool joints_out_of_range_ = true, unsupported_ = true;
  bool no_gravity_ = true, contradicts_attitude_ = true;
  Vector3 acceleration_ = Vector3::Zero();  // [m/s^2] IMU axes, low-pass filtered
};

}  // namespace surefoot
