// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detects legs whose encoders have stopped.
///
/// The encoders of a leg have stopped if angles and velocities of the leg repeat bit for bit,
/// although the repeated velocity means that the leg moves, and although another leg sends new
/// values. Two cases are no fault: a leg at rest may repeat its values; and all legs repeat
/// together if the robot measures its joints less often than it sends samples. Real-time: yes.
class EncoderMonitor {
 public:
  // The constants are chosen by hand. Tests: stopped_encoders_are_detected_within_60_ms,
  // moving_resting_or_slow_joints_are_not_dead_encoders.
  /// [rad/s] Velocity below which a joint may be at rest: twice the simulated noise of encoders,
  /// 0.05 rad/s.
  static constexpr double kMinSpeed = 0.1;
  /// [rad] Displacement, computed from the repeated velocity, from which the repetition is a fault.
  /// At 0.2 rad/s a joint needs 50 ms for this displacement. So the detection time of
  /// fault_table(), 60 ms, holds from 0.2 rad/s on.
  static constexpr double kMinDisplacement = 0.01;
  /// Number of samples in which another leg must have sent new values while this leg repeats: 10 ms
  /// at 500 Hz. Larger than the number of repetitions by chance.
  static constexpr int kMinSamples = 5;

  /// Process a sample.
  /// @param step [s] time since the previous sample
  /// @param lost_leg leg that is not checked, or -1
  void update(const LowState& state, double step, int lost_leg) noexcept {
    motor_ = -1;
    std::array<bool, kLegs> unchanged{};
    int unchanged_legs = 0;
    for (int leg = 0; leg < kLegs; ++leg) {
      unchanged[leg] = read(state, leg);
      unchanged_legs += unchanged[leg];
    }
    for (int leg = 0; leg < kLegs; ++leg) {
      Leg& record = legs_[leg];
      record.time = unchanged[leg] ? record.time + step : 0.0;
      record.other_changes = unchanged[leg] ? record.other_changes + (unchanged_legs < kLegs) : 0;
      const double speed = record.dq.cwiseAbs().maxCoeff();
      if (speed < kMinSpeed || speed * record.time < kMinDisplacement ||
          record.other_changes < kMinSamples)
        continue;
      if (motor_ < 0 && leg != lost_leg) motor_ = kLegJoints * leg + fastest(record.dq);
    }
  }
  /// Return the SDK number of the fastest motor in the first leg whose encoders have stopped,
  /// or -1.
  int motor() const noexcept { return motor_; }

 private:
  struct Leg {
    Vector3 q = Vector3::Constant(NAN), dq = Vector3::Zero();  // [rad], [rad/s] last sample
    double time = 0.0;      // [s] time for which q and dq have repeated
    int other_changes = 0;  // number of samples within `time` in which another leg changed
  };

  static int fastest(const Vector3& dq) noexcept {
    int at = 0;
    dq.cwiseAbs().maxCoeff(&at);
    return at;
  }

  // Store the values of a leg. Return whether they repeat the last values.
  bool read(const LowState& state, int leg) noexcept {
    Vector3 q, dq;
    for (int i = 0; i < kLegJoints; ++i) {
      q[i] = state.motorState[kLegJoints * leg + i].q;
      dq[i] = state.motorState[kLegJoints * leg + i].dq;
    }
    const bool unchanged = q == legs_[leg].q && dq == legs_[leg].dq;
    legs_[leg].q = q;
    legs_[leg].dq = dq;
    return unchanged;
  }

  std::array<Leg, kLegs> legs_;
  int motor_ = -1;
};

}  // namespace surefoot
