// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Detects stopped encoders of a leg.
///
/// The angles and velocities of the leg repeat bit for bit, although one of these velocities means
/// motion and other legs' samples change. Two cases are no fault: a leg at rest may repeat its
/// values, and all legs repeat together if joints are measured less often than samples are sent.
/// Real-time: yes.
class EncoderMonitor {
 public:
  // Chosen by hand; tests: stopped_encoders_are_detected_within_60_ms,
  // moving_resting_or_slow_joints_are_not_dead_encoders.
  /// [rad/s] a slower joint may be at rest: twice an offset of 0.05 rad/s, the noise of encoders.
  static constexpr double kMinSpeed = 0.1;
  /// [rad] travel by the repeated velocity before it is a fault: 50 ms at 0.2 rad/s, from which on
  /// the 60 ms of fault_table() hold.
  static constexpr double kMinTravel = 0.01;
  /// Samples in which another leg changed meanwhile: 10 ms at 500 Hz, above repeats by chance.
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
  /// Return the SDK number of the fastest motor of a leg with stopped encoders, or -1.
  int motor() const noexcept { return motor_; }

 private:
  struct Leg {
    Vector3 q = Vector3::Constant(NAN), dq = Vector3::Zero();  // [rad], [rad/s] of the last sample
    double time = 0.0;                                         // [s] for which they have repeated
    int other_changes = 0;  // samples of that time in which another leg changed
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
