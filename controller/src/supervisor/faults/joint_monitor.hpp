// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Compares the change of each joint angle with the joint's velocity, and rejects a sample if an
/// angle jumps:
///   |q - q_last - dq t| - kDisplacementTolerance |dq t| >= kMaxJump,   t: time since q_last
/// q_last is the angle in the last accepted sample. Real-time: yes.
class JointMonitor {
 public:
  // The constants are chosen by hand. Test: joint_motion_during_bad_samples_is_not_a_joint_jump.
  /// [rad] Jump from which an angle is rejected. Smaller than 0.2 rad, the jump of a hip in the row
  /// position_trip of `surefoot faults`.
  static constexpr double kMaxJump = 0.08;
  /// Tolerance, as a share of |dq t|, because velocities are delayed, noisy, or change within the
  /// step.
  static constexpr double kDisplacementTolerance = 0.5;
  /// [s] Any angles are accepted after angles have been rejected for this time. Same as in
  /// ImuMonitor.
  static constexpr double kReacceptTime = 0.5;

  /// Return whether the angles of a sample are usable.
  /// @param step [s] time since the last update
  /// @param lost_leg leg that is not checked, or -1
  bool update(const LowState& state, double step, int lost_leg) noexcept {
    age_ += step;
    Vector12 q, displacement;
    for (int i = 0; i < kMotors; ++i) {
      q[i] = state.motorState[i].q;
      displacement[i] = state.motorState[i].dq * age_;
    }
    Vector12 error =
        (q - q_ - displacement).cwiseAbs() - kDisplacementTolerance * displacement.cwiseAbs();
    if (lost_leg >= 0) error.segment<kLegJoints>(kLegJoints * lost_leg).setZero();
    if (started_ && age_ < kReacceptTime && !(error.array() < kMaxJump).all()) return false;
    q_ = q;
    age_ = 0.0;
    started_ = true;
    return true;
  }

 private:
  Vector12 q_ = Vector12::Zero();  // [rad] angles of the last accepted sample
  double age_ = 0.0;               // [s] time since the last accepted sample
  bool started_ = false;
};

}  // namespace surefoot
