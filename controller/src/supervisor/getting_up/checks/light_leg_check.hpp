// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Light leg check: detects legs much lighter than the model's, before the legs move.
///
/// The motors get the model's gravity torques of the legs, and springs hold the joints in place.
/// Springs carry nothing if the legs weigh what the model says, or rest on something. Lighter legs
/// rise against their springs, which take back a share of the gravity torque:
///   relief = 1 - measured / model
/// All legs that hang free have the same relief; a leg that rests on the ground has none. The legs
/// are too light if the relief agrees in enough joints, hips among them. Real-time: yes.
class LightLegCheck {
 public:
  // Chosen by hand; test: legs_far_lighter_than_expected_are_detected. Healthy robots that rise
  // pass (benchmarks/false_trips.py); a go1 with the model of a b1 fails (row wrong_robot).
  static constexpr double kDuration = 0.5;       ///< [s] of the check: twice TorqueFade::kTime
  static constexpr double kAveragingTime = 0.1;  ///< [s] at its end: torques are averaged
  static constexpr double kMinRelief = 0.4;      ///< smallest relief of a light leg ...
  static constexpr double kMaxRelief = 1.3;      ///< ... greatest: beyond, something else pushes it
  /// Of the greatest gravity torque: joints with less are skipped, because friction decides there.
  static constexpr double kMinTorqueShare = 0.3;
  static constexpr double kMaxDifference = 0.06;  ///< between reliefs that agree
  static constexpr double kMinJointShare = 0.5;  ///< of the judged joints: others rest on something
  static constexpr int kMinJoints = 3;           ///< ... and at least one leg's number of joints

  /// Add a sample. @param measured joint torques [N.m] @param model gravity torques of the legs
  /// [N.m], both SDK motor order @param dt [s]
  void update(const Vector12& measured, const Vector12& model, double dt) noexcept {
    time_ += dt;
    if (time_ <= kDuration - kAveragingTime) return;
    measured_ += measured;
    model_ += model;
  }
  bool done() const noexcept { return time_ >= kDuration; }
  /// Return the verdict, once done().
  bool too_light() const noexcept {
    const double min_torque = kMinTorqueShare * model_.cwiseAbs().maxCoeff();
    Vector12 relief = Vector12::Zero();
    int joints = 0, most_alike = 0;
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
      if (hips > 0 && hips < joints_alike) most_alike = std::max(most_alike, joints_alike);
    }
    return most_alike >= kMinJoints && most_alike >= kMinJointShare * joints;
  }

 private:
  Vector12 measured_ = Vector12::Zero(), model_ = Vector12::Zero();  // [N.m] sums
  double time_ = 0.0;                                                // [s]
};

}  // namespace surefoot
