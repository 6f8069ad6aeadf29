// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/state_estimator.hpp"

namespace surefoot {

/// Compares the displacements of joints and body by different sensors until the robot has moved.
///
///   joints:          change of q, integral of dq
///   turn of the body: integral of the gyroscope, change of the quaternion, integral of the rate at
///                    which the stance feet are at rest (rate_from_legs(): q and dq),
///                    within the turn that soft soles allow
/// All displacements are those of about the last 0.1 s. Of the three turns, two that agree outvote
/// the third. The legs are outvoted by their turn of about the last 0.5 s, because soft soles may
/// hide a smaller one. Sensors that agree about a motion are right: their check ends. Real-time:
/// yes.
class MotionCheck {
 public:
  /// Judge a sample that the estimator used.
  /// @param feet_stand false: feet step, so turns are not compared
  /// @return kOk, or the status that names a wrong sensor
  Status update(const LowState& low_state, const RobotConfig& config,
                const StateEstimator& estimator, bool feet_stand, double dt) noexcept;
  bool done() const noexcept { return joints_done_ && turns_done_; }
  void reset() noexcept { *this = MotionCheck(); }

 private:
  /// Turns of the body by each sensor, base axes [rad]; older motion fades.
  struct Turns {
    Vector3 gyroscope = Vector3::Zero(), quaternion = Vector3::Zero(), legs = Vector3::Zero();
    /// @param beyond_legs by which the turn of the gyroscope exceeds that of the legs
    void add(const Vector3& by_quaternion, const Vector3& by_legs, const Vector3& beyond_legs,
             double keep) noexcept;
  };

  Status judge_turns(const RobotConfig& config, const StateEstimator& estimator) noexcept;
  Status judge_joints(const StateEstimator& estimator) noexcept;
  Status wrong_joints(const StateEstimator& estimator) const noexcept;
  void read(const LowState& low_state, const RobotConfig& config, const StateEstimator& estimator,
            double dt) noexcept;
  void add_joints(const Vector12& by_q, const Vector12& by_dq, double keep) noexcept;

  bool started_ = false, joints_done_ = false, turns_done_ = false;
  bool has_quaternion_ = false;  // the last sample had a quaternion of unit length
  bool q_has_changed_ = false;
  Vector12 q_last_ = Vector12::Zero();
  Quaternion quaternion_last_ = Quaternion::Identity();          // base to world
  Vector12 by_q_ = Vector12::Zero(), by_dq_ = Vector12::Zero();  // [rad] displacements
  Turns turns_;                                                  // of about the last 0.1 s
  Turns long_turns_;                                             // of about the last 0.5 s
};

}  // namespace surefoot
