// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/leg_folding.hpp"

namespace surefoot {

/// Whether the rear legs of a lying robot are at its rear: they press, and the nose has to go down.
///
/// Legs that are swapped whole along one side differ in nothing but what they do to the body.
/// So, before the body leaves the ground, the rear pair alone is extended along the way that the
/// rise will take, at most by kMost of it, until the nose is down by kSeen. A pair on the diagonal
/// may well pitch the body too, but rolls it, sooner or later, and has all of its weight between
/// its feet, where a rear pair shares it with the nose: kRoll at kBothBear ends the press, as
/// kNoseUp does. Neither alone tells: a load beside the middle rolls a body that lies on a narrow
/// nose, and some bodies are heavy at the rear. What did not come is tried once more, for a body
/// may lie unevenly; then the check has failed. Legs that find nothing to press on say nothing: it
/// hangs, and may go on. Real-time: yes.
class LegPressing {
 public:
  static constexpr double kSeen = 0.06;      ///< [rad] nose down
  static constexpr double kNoseUp = 0.012;   ///< [rad]
  static constexpr double kRoll = 0.004;     ///< [rad] either way
  static constexpr double kBothBear = 0.24;  ///< of what legs bear standing on all four
  static constexpr double kBorne = 0.1;      ///< of it: below there is nothing to press on
  static constexpr double kMost = 0.35;      ///< of the way from lying to standing

  explicit LegPressing(const RisePlan& plan) : plan_(plan) {}

  /// @param reference of the folded legs, where it ended
  void start(const Vector12& reference) noexcept;
  /// @param R_world_base by the IMU @param borne share of the weight that the legs bear @param dt
  /// [s]
  const JointReference& step(const Quaternion& R_world_base, double borne, double dt) noexcept;
  bool passed() const noexcept { return lies() && seen_; }
  bool failed() const noexcept { return lies() && !seen_ && tries_ >= kTries; }
  /// SDK number of the first motor of the legs that press.
  static constexpr int motor() noexcept { return kLegJoints * kFirst; }

 private:
  static constexpr int kTries = 2;
  static constexpr int kFirst = 2;  // RR, and RL

  void watch(const Quaternion& R_world_base, double borne, double dt) noexcept;
  void move(double dt) noexcept;
  bool lies() const noexcept { return tries_ > 0 && !pressing_ && s_ == 0.0; }

  RisePlan plan_;
  JointReference reference_;
  Vector12 start_ = Vector12::Zero();             // [rad]
  Quaternion R_before_ = Quaternion::Identity();  // world to base as it began to press
  bool pressing_ = false, seen_ = false;
  int tries_ = 0;
  double s_ = 0.0, ds_ = 0.0;  // of the way, [1/s]
  double waited_ = 0.0;        // [s] at either end of it
};

}  // namespace surefoot
