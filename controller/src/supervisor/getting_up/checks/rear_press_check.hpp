// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "supervisor/getting_up/joint_reference.hpp"
#include "supervisor/getting_up/rise_plan.hpp"

namespace surefoot {

/// Rear press check: when the rear legs of a lying robot press on the ground, the front of the body
/// (the nose) must go down.
///
/// If front and rear leg of one side are swapped, only the motion of the body reveals this. So,
/// before the body leaves the ground, only the two rear legs extend along the path of RisePlan. The
/// rear legs stop at the path parameter s = kMaxExtension, or when the front of the body has gone
/// down by kMinNoseDown.
///
/// If the two pressing legs really are a diagonal pair, they also roll the body and carry all of
/// its weight; a true rear pair shares the weight with the front of the body. So the press fails if
/// the body rolls by kMaxRoll while the legs carry kDiagonalLoad, or if the front rises by
/// kMaxNoseUp. Neither roll nor load is sufficient alone: an off-centre payload also rolls a body
/// with a narrow front, and the rear legs of a rear-heavy body also carry much load. A failed press
/// is repeated once, because the body may lie unevenly. If the legs carry less than kMinLoad, the
/// robot hangs and the check passes. Real-time: yes.
class RearPressCheck {
 public:
  // The limits are chosen between values measured in simulation (docs/explanation/getting-up.md).
  // Roll: a true rear pair rolls an a1, go1 or b1 by at most 0.1 degrees, a diagonal pair by at
  // least 0.4 degrees. Load, as a share of the weight: a true rear pair of an a1, go1 or go2
  // carries at most 0.21, a diagonal pair at least 0.26. A true pair may exceed one of these limits
  // (a go2 rolls by 2.4 degrees), so both are needed. Tests: test_rise_checks.cpp.
  /// [rad] 3.4 degrees: the check passes if the front goes down by more than this.
  static constexpr double kMinNoseDown = 0.06;
  /// [rad] 0.7 degrees: the press fails if the front goes up by more than this.
  static constexpr double kMaxNoseUp = 0.012;
  /// [rad] 0.2 degrees: the press fails above this roll to either side, if the load is above
  /// kDiagonalLoad too.
  static constexpr double kMaxRoll = 0.004;
  /// [m g] Load on the legs, from load_share(), above which a pair that rolls the body is diagonal.
  static constexpr double kDiagonalLoad = 0.24;
  /// [m g] Load on the legs, from load_share(), below which the legs press on nothing.
  static constexpr double kMinLoad = 0.1;
  /// Largest s of the press. Chosen. If smaller: the front does not reach kMinNoseDown. If larger:
  /// the press raises the whole body.
  static constexpr double kMaxExtension = 0.35;

  explicit RearPressCheck(const RisePlan& plan) : plan_(plan) {}

  /// Start the check.
  /// @param reference joint angles of the folded legs [rad]
  void start(const Vector12& reference) noexcept;
  /// Advance by dt [s] and return the joint reference.
  /// @param R_world_base attitude from the IMU
  /// @param load share of the weight on the legs, from JointImpedance::load_share()
  const JointReference& step(const Quaternion& R_world_base, double load, double dt) noexcept;
  bool passed() const noexcept { return is_lowered() && nose_went_down_; }
  bool failed() const noexcept { return is_lowered() && !nose_went_down_ && tries_ >= kTries; }
  /// Return the SDK number of the first motor of the two pressing legs.
  static constexpr int motor() noexcept { return kLegJoints * kFirstLeg; }

 private:
  static constexpr int kTries = 2;     // chosen: the body may lie unevenly at the first try
  static constexpr int kFirstLeg = 2;  // RR; the second pressing leg is RL

  void update_press(const Quaternion& R_world_base, double load, double dt) noexcept;
  void step_path(double dt) noexcept;
  // Return whether the legs are folded again after a press.
  bool is_lowered() const noexcept { return tries_ > 0 && !pressing_ && s_ == 0.0; }

  RisePlan plan_;
  JointReference reference_;
  Vector12 q_start_ = Vector12::Zero();           // [rad] joint angles at the start
  Quaternion R_before_ = Quaternion::Identity();  // attitude at the start of the press
  bool pressing_ = false, nose_went_down_ = false;
  int tries_ = 0;
  double s_ = 0.0, ds_ = 0.0;  // s_: path parameter; ds_: its rate [1/s]
  double wait_time_ = 0.0;     // [s] time for which s has been at its goal: kMaxExtension or 0
};

}  // namespace surefoot
