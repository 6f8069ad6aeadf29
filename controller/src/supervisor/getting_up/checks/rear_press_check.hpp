// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Whether the rear legs of a lying robot are at its rear: they press, and the nose has to go down.
///
/// Legs that are swapped whole along one side differ in nothing but what they do to the body.
/// So, before the body leaves the ground, the rear pair alone is extended along the way that the
/// rise will take, at most by kMaxExtension of it, until the nose is down by kMinNoseDown. A pair
/// on the diagonal may well pitch the body too, but rolls it, sooner or later, and has all of its
/// weight between its feet, where a rear pair shares it with the nose: kMaxRoll at kDiagonalLoad
/// ends the press, as kMaxNoseUp does. Neither alone tells: a load beside the middle rolls a body
/// that lies on a narrow nose, and some bodies are heavy at the rear. What did not come is tried
/// once more, for a body may lie unevenly; then the check has failed. Legs that find nothing to
/// press on say nothing: it hangs, and may go on. Real-time: yes.
class RearPressCheck {
 public:
  static constexpr double kMinNoseDown = 0.06;   ///< [rad] nose down
  static constexpr double kMaxNoseUp = 0.012;    ///< [rad]
  static constexpr double kMaxRoll = 0.004;      ///< [rad] either way
  static constexpr double kDiagonalLoad = 0.24;  ///< of what legs bear standing on all four
  static constexpr double kMinLoad = 0.1;        ///< of it: below there is nothing to press on
  static constexpr double kMaxExtension = 0.35;  ///< of the way from lying to standing

  explicit RearPressCheck(const RisePlan& plan) : plan_(plan) {}

  /// @param reference of the folded legs, where it ended
  void start(const Vector12& reference) noexcept;
  /// @param R_world_base by the IMU @param load share of the weight that the legs bear @param dt
  /// [s]
  const JointReference& step(const Quaternion& R_world_base, double load, double dt) noexcept;
  bool passed() const noexcept { return is_lowered() && nose_went_down_; }
  bool failed() const noexcept { return is_lowered() && !nose_went_down_ && tries_ >= kTries; }
  /// SDK number of the first motor of the legs that press.
  static constexpr int motor() noexcept { return kLegJoints * kFirstLeg; }

 private:
  static constexpr int kTries = 2;
  static constexpr int kFirstLeg = 2;  // RR, and RL

  void evaluate(const Quaternion& R_world_base, double load, double dt) noexcept;
  void step_path(double dt) noexcept;
  bool is_lowered() const noexcept { return tries_ > 0 && !pressing_ && s_ == 0.0; }

  RisePlan plan_;
  JointReference reference_;
  Vector12 q_start_ = Vector12::Zero();           // [rad]
  Quaternion R_before_ = Quaternion::Identity();  // world to base as it began to press
  bool pressing_ = false, nose_went_down_ = false;
  int tries_ = 0;
  double s_ = 0.0, ds_ = 0.0;  // of the way, [1/s]
  double wait_time_ = 0.0;     // [s] at either end of it
};

}  // namespace surefoot
