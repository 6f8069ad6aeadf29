// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Notices a leg whose angles and speeds repeat themselves bit by bit, while one of those speeds
/// says that the joint moves and the other legs' reports go on. At rest encoders may well repeat
/// themselves; and all legs together do so where joints are measured less often than the link runs.
/// Real-time: yes.
class EncoderWatch {
 public:
  static constexpr double kMoving = 0.1;  ///< [rad/s] below it a joint may as well be at rest
  static constexpr double kWay = 0.01;    ///< [rad] that the joint says it has gone without going
  static constexpr int kReports = 5;      ///< in which another leg has changed meanwhile

  /// Judge a report. @param step [s] since the report before @param lost_leg that is not judged,
  /// -1: all are
  void update(const LowState& state, double step, int lost_leg) noexcept {
    motor_ = -1;
    std::array<bool, kLegs> same{};
    int still = 0;
    for (int leg = 0; leg < kLegs; ++leg) {
      same[leg] = read(state, leg);
      still += same[leg];
    }
    for (int leg = 0; leg < kLegs; ++leg) {
      Leg& one = legs_[leg];
      one.time = same[leg] ? one.time + step : 0.0;
      one.others = same[leg] ? one.others + (still < kLegs) : 0;
      const double speed = one.dq.cwiseAbs().maxCoeff();
      if (speed < kMoving || speed * one.time < kWay || one.others < kReports) continue;
      if (motor_ < 0 && leg != lost_leg) motor_ = kLegJoints * leg + fastest(one.dq);
    }
  }
  /// SDK number of the motor whose encoder has stopped, or -1.
  int motor() const noexcept { return motor_; }

 private:
  struct Leg {
    Vector3 q = Vector3::Constant(NAN), dq = Vector3::Zero();  // as last reported
    double time = 0.0;                                         // [s] that they repeat
    int others = 0;  // reports of that time in which another leg changed
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
    const bool same = q == legs_[leg].q && dq == legs_[leg].dq;
    legs_[leg].q = q;
    legs_[leg].dq = dq;
    return same;
  }

  std::array<Leg, kLegs> legs_;
  int motor_ = -1;
};

}  // namespace surefoot
