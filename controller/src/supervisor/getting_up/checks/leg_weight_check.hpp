// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Leg weight check: compares the hip torques of a lying robot's folded legs with the model's.
///
/// A leg that is held outward in the air needs a hip torque. Its sign shows the side of the body
/// and the direction of the motor; its size shows the weight of the leg, and with it the size of
/// the robot. Nothing else tells two swapped legs apart: their samples and commands agree.
///
/// The hips move outward by kHipOutward, because the body may rest on straight legs. A leg on the
/// wrong side moves inward instead and soon lies on the ground. After a pause the torques are
/// averaged, then the hips move back. The verdict is from ratio = measured / model of each leg:
/// ratios that are wrong and alike mean another robot, one that differs means a wrong side.
///
/// If legs of one side do not fold, the other side is weighed alone. The body may lean on these
/// legs, which reduces or reverses their torque. So only kMaxPartialRatio is checked. Real-time:
/// yes.
class LegWeightCheck {
 public:
  // Chosen between measured ratios (benchmarks/false_trips.py, docs/faults.md): 0.92 to 1.07 for
  // healthy robots with payloads to 30 % on slopes to 8 degrees; 4 to 12 for swapped legs, 7 for a
  // b1 with the model of a go1. Tests: tests/cpp/test_rise_checks.cpp.
  /// [rad] motion of the hips. Below: the body may rest on straight legs; above: the hips' range.
  static constexpr double kHipOutward = 0.35;
  static constexpr double kMinRatio = 0.4;  ///< smallest ratio of a leg that hangs free ...
  static constexpr double kMaxRatio = 2.5;  ///< ... greatest, with friction of its hip
  /// Heaviest over lightest leg, below which they are alike: another robot, not a wrong side.
  static constexpr double kMaxSpread = 2.0;
  static constexpr double kMinMeanRatio = 0.6;  ///< smallest mean ratio of all legs ...
  static constexpr double kMaxMeanRatio = 1.5;  ///< ... greatest, with shin guards and the like
  /// Greatest ratio where one side is weighed alone: below the 4 of swapped legs.
  static constexpr double kMaxPartialRatio = 3.0;

  enum class Verdict { kNone = 0, kFits, kWrongSide, kWrongWeight };

  explicit LegWeightCheck(const RisePlan& plan) : plan_(plan) {}

  /// Start the check. @param reference joint angles at the end of folding [rad]
  /// @param legs folded legs that are weighed, FR FL RR RL
  void start(const Vector12& reference, const std::array<bool, kLegs>& legs) noexcept;
  /// Advance by dt [s] and return the joint reference. @param measured joint torques [N.m]
  /// @param model gravity torques of the legs [N.m]
  const JointReference& step(const Vector12& measured, const Vector12& model, double dt) noexcept;
  Verdict verdict() const noexcept { return verdict_; }
  /// Return the SDK number of the hip found on the wrong side, or -1.
  int motor() const noexcept { return motor_; }

 private:
  void judge() noexcept;

  RisePlan plan_;
  JointReference reference_;
  std::array<bool, kLegs> legs_ = {};
  Vector12 q_start_ = Vector12::Zero();                 // [rad]
  Eigen::Vector4d measured_ = Eigen::Vector4d::Zero();  // [N.m] hips, sums
  Eigen::Vector4d model_ = Eigen::Vector4d::Zero();     // [N.m]
  double time_ = 0.0;                                   // [s]
  Verdict verdict_ = Verdict::kNone;
  int motor_ = -1;
};

}  // namespace surefoot
