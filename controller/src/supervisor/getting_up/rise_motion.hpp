// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Moves the joint reference along the path of RisePlan, up or down. go_to() may reverse the motion
/// at any point.
///
/// s is the path parameter: 0 lying, 1 standing. Its rate ds/dt stays within the plan's limit and
/// falls smoothly to zero at the goal. On the way up, the motion waits for joints that lag behind.
/// Real-time: yes.
class RiseMotion {
 public:
  explicit RiseMotion(const RisePlan& plan) : plan_(plan) {}

  /// Start at s with these joint angles [rad]. Their offset from the path is faded out within a
  /// second.
  void start(double s, const Vector12& joints) noexcept;
  /// Set the goal, 0 .. 1.
  void go_to(double s) noexcept {
    goal_ = s;
    stalled_time_ = 0.0;
  }
  /// Advance by dt [s] and return the reference. @param measured joint angles [rad]
  const JointReference& step(const Vector12& measured, double dt) noexcept;

  /// Return the present path parameter s, 0 .. 1.
  double position() const noexcept { return s_; }
  /// Return whether s is at the goal and the initial offset has faded out.
  bool arrived() const noexcept;
  /// Return the planned share of the weight on the legs. It rises from 0 at s = 0 to 1 at
  /// s = kLoadingRange = 0.25.
  double load() const noexcept;
  /// Return whether joints have lagged behind for longer than kStallTimeout.
  bool stuck() const noexcept { return stalled_time_ > kStallTimeout; }

 private:
  // [s] Chosen: about the duration of the path, 1.9 s from folded to standing.
  static constexpr double kStallTimeout = 2.0;

  RisePlan plan_;
  JointReference reference_;
  Vector12 offset_ = Vector12::Zero();  // [rad] offset of the joints from the path at the start
  double goal_ = 0.0;
  double s_ = 0.0, ds_ = 0.0;  // s_: path parameter; ds_: its rate [1/s]
  double time_ = 0.0;          // [s] time since the start
  double stalled_time_ = 0.0;  // [s] time for which joints have lagged behind
};

}  // namespace surefoot
