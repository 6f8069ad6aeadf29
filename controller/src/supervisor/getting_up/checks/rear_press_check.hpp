// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Rear press check: the rear legs of a lying robot press, and its nose must go down.
///
/// Front and rear legs that are swapped on one side differ only in their effect on the body. So,
/// before the body leaves the ground, the rear pair alone extends along the path of the rise, at
/// most to s = kMaxExtension, until the nose is down by kMinNoseDown.
///
/// If the pair is in truth a diagonal one, it also rolls the body, and carries all of its weight; a
/// true rear pair shares the weight with the nose. So a roll of kMaxRoll at kDiagonalLoad ends the
/// press as a failure, and so does a nose that rises by kMaxNoseUp. Roll or load alone proves
/// nothing: an off-centre payload rolls a body with a narrow nose, and some bodies are heavy at the
/// rear. A failed press is repeated once, because the body may lie unevenly. If the legs find
/// nothing to press on, the robot hangs and the check passes. Real-time: yes.
class RearPressCheck {
 public:
  // Chosen between figures measured in simulation (docs/faults.md). A true rear pair rolls an a1,
  // go1 and b1 by 0.1 degrees at most and carries up to 0.21 of an a1, go1 and go2; diagonal pairs
  // roll a body by 0.4 degrees or more and carry 0.26 or more. Tests: test_rise_checks.cpp.
  static constexpr double kMinNoseDown = 0.06;   ///< [rad] 3.4 degrees: pitch that passes
  static constexpr double kMaxNoseUp = 0.012;    ///< [rad] 0.7 degrees: pitch that fails
  static constexpr double kMaxRoll = 0.004;      ///< [rad] 0.2 degrees to either side
  static constexpr double kDiagonalLoad = 0.24;  ///< share of the weight, by load_share()
  static constexpr double kMinLoad = 0.1;  ///< share of the weight: below, nothing to press on
  /// Greatest s of the rise path: chosen, enough for kMinNoseDown and not to raise the body.
  static constexpr double kMaxExtension = 0.35;

  explicit RearPressCheck(const RisePlan& plan) : plan_(plan) {}

  /// Start the check. @param reference joint angles of the folded legs [rad]
  void start(const Vector12& reference) noexcept;
  /// Advance by dt [s] and return the joint reference.
  /// @param R_world_base attitude by the IMU @param load JointImpedance::load_share()
  const JointReference& step(const Quaternion& R_world_base, double load, double dt) noexcept;
  bool passed() const noexcept { return is_lowered() && nose_went_down_; }
  bool failed() const noexcept { return is_lowered() && !nose_went_down_ && tries_ >= kTries; }
  /// Return the SDK number of the first motor of the pressing legs.
  static constexpr int motor() noexcept { return kLegJoints * kFirstLeg; }

 private:
  static constexpr int kTries = 2;     // chosen: the body may lie unevenly at the first
  static constexpr int kFirstLeg = 2;  // RR; RL is the other one

  void evaluate(const Quaternion& R_world_base, double load, double dt) noexcept;
  void step_path(double dt) noexcept;
  bool is_lowered() const noexcept { return tries_ > 0 && !pressing_ && s_ == 0.0; }

  RisePlan plan_;
  JointReference reference_;
  Vector12 q_start_ = Vector12::Zero();           // [rad]
  Quaternion R_before_ = Quaternion::Identity();  // attitude at the start of the press
  bool pressing_ = false, nose_went_down_ = false;
  int tries_ = 0;
  double s_ = 0.0, ds_ = 0.0;  // [1] of the path, [1/s]
  double wait_time_ = 0.0;     // [s] at either end of the motion
};

}  // namespace surefoot
