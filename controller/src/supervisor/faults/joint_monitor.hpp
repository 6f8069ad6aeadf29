// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Compares the change of each joint angle with its velocity and rejects angles that jump:
///   |q - q_last - dq t| - kTravelTolerance |dq t| >= kMaxJump,   t: time since q_last
/// Real-time: yes.
class JointMonitor {
 public:
  // Chosen by hand; test: joint_motion_during_bad_samples_is_not_a_joint_jump.
  /// [rad] Change of an angle beyond the displacement by its velocity from which the angle has
  /// jumped. Must be below 0.2 rad, the jump of a hip in the row position_trip of `surefoot
  /// faults`.
  static constexpr double kMaxJump = 0.08;
  /// [displacement by the velocity] Tolerance for velocities that are delayed, noisy or change
  /// within the step.
  static constexpr double kTravelTolerance = 0.5;
  /// [s] Time of rejection after which any angles are accepted. Same as in ImuMonitor.
  static constexpr double kReacceptTime = 0.5;

  /// Return whether the angles of a sample are usable.
  /// @param step [s] since the last update @param lost_leg leg that is not judged, or -1
  bool update(const LowState& state, double step, int lost_leg) noexcept {
    age_ += step;
    Vector12 q, travel;
    for (int i = 0; i < kMotors; ++i) {
      q[i] = state.motorState[i].q;
      travel[i] = state.motorState[i].dq * age_;
    }
    Vector12 error = (q - q_ - travel).cwiseAbs() - kTravelTolerance * travel.cwiseAbs();
    if (lost_leg >= 0) error.segment<kLegJoints>(kLegJoints * lost_leg).setZero();
    if (started_ && age_ < kReacceptTime && !(error.array() < kMaxJump).all()) return false;
    q_ = q;
    age_ = 0.0;
    started_ = true;
    return true;
  }

 private:
  Vector12 q_ = Vector12::Zero();  // [rad] angles of the last accepted sample
  double age_ = 0.0;               // [s] since the last accepted sample
  bool started_ = false;
};

}  // namespace surefoot
