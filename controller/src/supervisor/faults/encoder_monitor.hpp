// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detects encoders of a leg that have stopped.
///
/// It is a fault if the angles and velocities of a leg repeat bit for bit, although the repeated
/// velocity of one joint means motion and the samples of another leg change. Two cases are no
/// fault: a leg at rest may repeat its values, and all legs repeat together if the robot measures
/// joints less often than it sends samples. Real-time: yes.
class EncoderMonitor {
 public:
  // Chosen by hand; tests: stopped_encoders_are_detected_within_60_ms,
  // moving_resting_or_slow_joints_are_not_dead_encoders.
  /// [rad/s] Velocity below which a joint may be at rest: twice 0.05 rad/s, the noise of encoders.
  static constexpr double kMinSpeed = 0.1;
  /// [rad] Displacement by the repeated velocity from which this is a fault: 50 ms at 0.2 rad/s.
  /// The 60 ms of fault_table() apply from this velocity on.
  static constexpr double kMinTravel = 0.01;
  /// Number of samples in which another leg must have changed: 10 ms at 500 Hz. Must exceed the
  /// number of repeats by chance.
  static constexpr int kMinSamples = 5;

  /// Judge a sample.
  /// @param step [s] since the previous sample @param lost_leg leg that is not judged, or -1
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
      if (speed < kMinSpeed || speed * record.time < kMinTravel ||
          record.other_changes < kMinSamples)
        continue;
      if (motor_ < 0 && leg != lost_leg) motor_ = kLegJoints * leg + fastest(record.dq);
    }
  }
  /// Return the SDK number of the fastest motor of a leg whose encoders have stopped, or -1.
  int motor() const noexcept { return motor_; }

 private:
  struct Leg {
    Vector3 q = Vector3::Constant(NAN), dq = Vector3::Zero();  // [rad], [rad/s] in the last sample
    double time = 0.0;      // [s] for which q and dq have repeated
    int other_changes = 0;  // number of samples in this time in which another leg changed
  };

  static int fastest(const Vector3& dq) noexcept {
    int at = 0;
    dq.cwiseAbs().maxCoeff(&at);
    return at;
  }

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
