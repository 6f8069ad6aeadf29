// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Notices a leg whose angles and speeds repeat themselves bit by bit, while one of those speeds
/// says that the joint moves and the other legs' reports go on. At rest encoders may well repeat
/// themselves; and all legs together do so where joints are measured less often than the link runs.
/// Real-time: yes.
class EncoderMonitor {
 public:
  static constexpr double kMinSpeed = 0.1;  ///< [rad/s] below it a joint may as well be at rest
  static constexpr double kMinTravel =
      0.01;                              ///< [rad] that the joint says it has gone without going
  static constexpr int kMinSamples = 5;  ///< in which another leg has changed meanwhile

  /// Judge a report. @param step [s] since the report before @param lost_leg that is not judged,
  /// -1: all are
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
  /// SDK number of the motor whose encoder has stopped, or -1.
  int motor() const noexcept { return motor_; }

 private:
  struct Leg {
    Vector3 q = Vector3::Constant(NAN), dq = Vector3::Zero();  // as last reported
    double time = 0.0;                                         // [s] that they repeat
    int other_changes = 0;  // reports of that time in which another leg changed
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
