// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Leg weight check: compares the hip torques of a lying robot's folded legs with those of the
/// model.
///
/// A leg that is held outward in the air needs a hip torque. The sign of the torque shows the side
/// of the body and the direction of the motor. The size of the torque shows the weight of the leg,
/// and so whether the robot is the robot of the model. No other measurement reveals two swapped
/// legs, because their samples and commands agree with each other.
///
/// The hips move outward by kHipOutward, because the body may rest on legs whose hips are straight.
/// A leg on the wrong side moves inward instead and soon lies on the ground. After a pause the
/// torques are averaged, then the hips move back. The verdict uses the ratio of each leg: measured
/// hip torque / hip torque of the model. If all ratios are wrong by a similar factor, the robot is
/// not the robot of the model. If the ratio of one leg differs from the others, this leg is on the
/// wrong side.
///
/// If the legs of one side do not fold, only the legs of the other side are weighed. The body may
/// lean on the weighed legs, which reduces or reverses their torques. So only kMaxPartialRatio is
/// checked in this case. Real-time: yes.
class LegWeightCheck {
 public:
  // The limits are chosen between ratios measured with benchmarks/false_trips.py
  // (docs/explanation/getting-up.md). Healthy robots with payloads up to 30 % on slopes up to 8
  // degrees: 0.92 to 1.07. Swapped legs: 4 to 12. A b1 with the model of a go1: 7. Tests:
  // tests/cpp/test_rise_checks.cpp.
  /// [rad] Angle by which the hips move. If smaller: the body may still rest on the legs. If
  /// larger: the motion exceeds the range of the hips.
  static constexpr double kHipOutward = 0.35;
  static constexpr double kMinRatio = 0.4;  ///< Smallest ratio of a leg that hangs free.
  /// Largest ratio of a leg that hangs free, friction of its hip included.
  static constexpr double kMaxRatio = 2.5;
  /// Ratios are alike if the largest ratio divided by the smallest is below this value. If the
  /// ratios are wrong but alike, no leg is on the wrong side: it is another robot.
  static constexpr double kMaxSpread = 2.0;
  static constexpr double kMinMeanRatio = 0.6;  ///< Smallest mean ratio of all legs.
  /// Largest mean ratio of all legs, with shin guards or other additional parts.
  static constexpr double kMaxMeanRatio = 1.5;
  /// Largest ratio if only one side is weighed. Smaller than 4, the smallest ratio of swapped legs.
  static constexpr double kMaxPartialRatio = 3.0;

  enum class Verdict { kNone = 0, kFits, kWrongSide, kWrongWeight };

  explicit LegWeightCheck(const RisePlan& plan) : plan_(plan) {}

  /// Start the check.
  /// @param reference joint angles at the end of folding [rad]
  /// @param legs folded legs that are weighed, FR FL RR RL
  void start(const Vector12& reference, const std::array<bool, kLegs>& legs) noexcept;
  /// Advance by dt [s] and return the joint reference.
  /// @param measured joint torques, SDK motor order [N.m]
  /// @param model gravity torques of the model's legs, SDK motor order [N.m]
  const JointReference& step(const Vector12& measured, const Vector12& model, double dt) noexcept;
  Verdict verdict() const noexcept { return verdict_; }
  /// Return the SDK number of the hip that was found on the wrong side, or -1.
  int motor() const noexcept { return motor_; }

 private:
  void judge() noexcept;

  RisePlan plan_;
  JointReference reference_;
  std::array<bool, kLegs> legs_ = {};
  Vector12 q_start_ = Vector12::Zero();                 // [rad] joint angles at the start
  Eigen::Vector4d measured_ = Eigen::Vector4d::Zero();  // [N.m] sums of measured hip torques
  Eigen::Vector4d model_ = Eigen::Vector4d::Zero();     // [N.m] sums of the model's hip torques
  double time_ = 0.0;                                   // [s] time since the start
  Verdict verdict_ = Verdict::kNone;
  int motor_ = -1;
};

}  // namespace surefoot
