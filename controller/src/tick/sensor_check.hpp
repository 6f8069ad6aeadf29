// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/state_estimator.hpp"
#include "tick/first_samples.hpp"
#include "tick/motion_check.hpp"
#include "tick/torque_gain.hpp"

namespace surefoot {

/// Finds a sensor that has been wrong since the first sample: wrong unit, sign or order, or stuck.
///
/// Each sensor is compared with what the other sensors say about the same quantity:
///   FirstSamples: gravity, joint ranges and support, while the robot still stands as it was put
///   TorqueGain:   tauEst against the commanded torques, over the first 0.2 s
///   MotionCheck:  the displacements by q, dq, gyroscope, quaternion and legs, at the first motion
/// A sensor that has agreed once is not judged again. So a sensor that fails later is left to the
/// estimator and the supervisor. Real-time: yes, except the constructor.
class SensorCheck {
 public:
  explicit SensorCheck(const Robot& robot);

  /// Judge a sample.
  /// @param estimated status of the estimator for this sample
  /// @param estimator state after this sample
  /// @param commanded [N.m] torques that acted when the sample was measured, or null
  /// @param dt [s] since the last judged sample
  /// @return kOk, or the status that names the wrong sensor, kept until reset()
  Status update(const LowState& low_state, Status estimated, const StateEstimator& estimator,
                const Vector12* commanded, double dt) noexcept;
  void reset() noexcept;
  /// End the check for good: update() returns kOk, also after reset().
  void end() noexcept { ended_ = true; }

 private:
  Robot robot_;
  FirstSamples first_samples_;
  TorqueGain torque_gain_;
  MotionCheck motion_;
  Status found_ = Status::kOk;
  bool ended_ = false;  // set by end()
};

}  // namespace surefoot
