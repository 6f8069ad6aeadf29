// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Moves along RisePlan's line, up or down, and may be turned round on the way. Real-time: yes.
class RiseMotion {
 public:
  explicit RiseMotion(const RisePlan& plan) : plan_(plan) {}

  /// Begin at s, with joints that need not be exactly there: what they are off fades out in a
  /// second.
  void start(double s, const Vector12& joints) noexcept;
  void go_to(double s) noexcept {
    goal_ = s;
    stalled_time_ = 0.0;
  }
  const JointReference& step(const Vector12& measured, double dt) noexcept;

  double position() const noexcept { return s_; }
  bool arrived() const noexcept;
  /// Share of the weight that the legs are meant to bear: none on the ground, all once they lift.
  double load() const noexcept;
  /// Have the joints been unable to follow for long?
  bool stuck() const noexcept { return stalled_time_ > kStallTimeout; }

 private:
  static constexpr double kStallTimeout = 2.0;  // [s]

  RisePlan plan_;
  JointReference reference_;
  Vector12 offset_ = Vector12::Zero();  // [rad] of the joints where the motion began
  double goal_ = 0.0;
  double s_ = 0.0, ds_ = 0.0;  // ds_ in 1/s
  double time_ = 0.0;          // [s] since the start
  double stalled_time_ = 0.0;  // [s]
};

}  // namespace surefoot
