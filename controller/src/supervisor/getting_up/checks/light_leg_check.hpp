// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Light leg check: detects legs that are much lighter than those of the model, before the legs
/// move.
///
/// The motors get the gravity torques of the model's legs, and springs hold the joints in place.
/// The spring torques are zero if the legs have the weight of the model's legs, or rest on
/// something. Lighter legs rise against their springs, and the springs then cancel a share of the
/// gravity torque:
///   relief = 1 - measured / model
/// All legs that hang free have the same relief; a leg that rests on the ground has none. The legs
/// are too light if enough joints have the same relief, among them at least one hip and at least
/// one other joint. Real-time: yes.
class LightLegCheck {
 public:
  // The constants are chosen by hand. Test: legs_far_lighter_than_expected_are_detected. Healthy
  // robots that rise pass (benchmarks/false_trips.py); a go1 with the model of a b1 fails (row
  // wrong_robot).
  static constexpr double kDuration = 0.5;  ///< [s] duration of the check: twice TorqueFade::kTime
  /// [s] Last part of the check, in which torques are averaged.
  static constexpr double kAveragingTime = 0.1;
  static constexpr double kMinRelief = 0.4;  ///< smallest relief of a light leg
  /// Largest relief of a light leg. Above this value another force pushes the leg.
  static constexpr double kMaxRelief = 1.3;
  /// Gravity torque, as a share of the largest gravity torque, below which a joint is not counted,
  /// because friction dominates.
  static constexpr double kMinTorqueShare = 0.3;
  static constexpr double kMaxDifference = 0.06;  ///< largest difference between reliefs that agree
  /// Share of the counted joints that must agree. Below 1, because some joints may rest on
  /// something.
  static constexpr double kMinJointShare = 0.5;
  /// Number of joints that must agree: as many as one leg has.
  static constexpr int kMinJoints = 3;

  /// Process a sample. Torques are in SDK motor order.
  /// @param measured joint torques [N.m]
  /// @param model gravity torques of the model's legs [N.m]
  /// @param dt [s] time since the previous sample
  void update(const Vector12& measured, const Vector12& model, double dt) noexcept {
    time_ += dt;
    if (time_ <= kDuration - kAveragingTime) return;
    measured_ += measured;
    model_ += model;
  }
  bool done() const noexcept { return time_ >= kDuration; }
  /// Return whether the legs are too light. The result is valid once done() is true.
  bool too_light() const noexcept {
    const double min_torque = kMinTorqueShare * model_.cwiseAbs().maxCoeff();
    Vector12 relief = Vector12::Zero();
    int joints = 0, max_joints_alike = 0;
    for (int i = 0; i < kMotors; ++i) {
      if (std::abs(model_[i]) < min_torque) continue;
      ++joints;
      relief[i] = 1.0 - measured_[i] / model_[i];
    }
    for (int i = 0; i < kMotors; ++i) {
      if (!(relief[i] > kMinRelief && relief[i] < kMaxRelief)) continue;
      const Eigen::Array<bool, kMotors, 1> similar =
          (relief.array() - relief[i]).abs() < kMaxDifference;
      int hips = 0;
      for (int leg = 0; leg < kLegs; ++leg) hips += similar[kLegJoints * leg];
      const int joints_alike = static_cast<int>(similar.count());
      if (hips > 0 && hips < joints_alike)
        max_joints_alike = std::max(max_joints_alike, joints_alike);
    }
    return max_joints_alike >= kMinJoints && max_joints_alike >= kMinJointShare * joints;
  }

 private:
  Vector12 measured_ = Vector12::Zero(), model_ = Vector12::Zero();  // [N.m] sums of torques
  double time_ = 0.0;                                                // [s] time since the start
};

}  // namespace surefoot
