// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Whether the folded legs of a lying robot weigh on their hips as the model says.
///
/// A leg that is held outward in the air asks its hip for a torque whose sign says on which side of
/// the body it is and which way its motor turns, and whose size is the leg's weight: as good as the
/// robot's size. Reports and commands of two legs that are swapped whole agree with each other in
/// all else. The hips go outward by kHipOutward, for a body may rest on them when they are
/// straight; one on the wrong side goes inward, and soon lies on the ground. After a rest torques
/// are averaged; then the hips go back.
///
/// Where some legs are stuck the others are weighed alone, and the body may lean on them: it bears
/// a part of what they weigh, or turns it round, but makes none of them several times too heavy.
/// Real-time: yes.
class LegWeightCheck {
 public:
  static constexpr double kHipOutward = 0.35;  ///< [rad]
  static constexpr double kMinRatio = 0.4;  ///< times the model's weight: a leg that hangs free ...
  static constexpr double kMaxRatio = 2.5;  ///< ... is between these, however its hip rubs
  static constexpr double kMaxSpread =
      2.0;  ///< times the lightest leg: so much may the heaviest weigh
  static constexpr double kMinMeanRatio = 0.6;  ///< the same of all legs together ...
  static constexpr double kMaxMeanRatio = 1.5;  ///< ... and whatever they are dressed in
  static constexpr double kMaxPartialRatio =
      3.0;  ///< times the weight of one weighed without all others

  enum class Verdict { kNone = 0, kFits, kWrongSide, kWrongWeight };

  explicit LegWeightCheck(const RisePlan& plan) : plan_(plan) {}

  /// @param reference of the legs, where folding ended @param legs that are folded and are weighed
  void start(const Vector12& reference, const std::array<bool, kLegs>& legs) noexcept;
  /// @param measured, model torques of all motors that hold the legs up [N.m] @param dt [s]
  const JointReference& step(const Vector12& measured, const Vector12& model, double dt) noexcept;
  Verdict verdict() const noexcept { return verdict_; }
  /// SDK number of the hip that was found on the wrong side, or -1.
  int motor() const noexcept { return motor_; }

 private:
  void judge() noexcept;

  RisePlan plan_;
  JointReference reference_;
  std::array<bool, kLegs> legs_ = {};
  Vector12 q_start_ = Vector12::Zero();                 // [rad]
  Eigen::Vector4d measured_ = Eigen::Vector4d::Zero();  // [N.m] hips, summed up
  Eigen::Vector4d model_ = Eigen::Vector4d::Zero();     // [N.m]
  double time_ = 0.0;                                   // [s]
  Verdict verdict_ = Verdict::kNone;
  int motor_ = -1;
};

}  // namespace surefoot
