// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "surefoot/low_level.hpp"
#include "surefoot/math.hpp"

namespace surefoot {

/// Whether lying legs that are told what bears them float: springs hold them where they are, and
/// have nothing to do as long as the legs weigh what the model says, or rest on something. Those of
/// a much smaller robot come up against their springs, by what they weigh less: all that hang free
/// by the same share. (What rests on the ground does not: it stays where it is.) Real-time: yes.
class LightLegCheck {
 public:
  static constexpr double kDuration = 0.5;  ///< [s] in all: torques fade in for half of it
  static constexpr double kAveragingTime =
      0.1;                                   ///< [s] at its end, over which torques are averaged
  static constexpr double kMinRelief = 0.4;  ///< of what bears a leg that its spring takes back ...
  static constexpr double kMaxRelief = 1.3;  ///< ... no more: then something else pushes it
  static constexpr double kMinTorqueShare =
      0.3;  ///< of the greatest such torque: below it a joint is none
  static constexpr double kMaxDifference =
      0.06;  ///< that these shares may differ from one of them ...
  static constexpr double kMinJointShare =
      0.5;                              ///< ... in so many of the joints, hips and others ...
  static constexpr int kMinJoints = 3;  ///< ... and no fewer than these

  /// @param measured, model torques of all motors that bear the legs [N.m] @param dt [s]
  void update(const Vector12& measured, const Vector12& model, double dt) noexcept {
    time_ += dt;
    if (time_ <= kDuration - kAveragingTime) return;
    measured_ += measured;
    model_ += model;
  }
  bool done() const noexcept { return time_ >= kDuration; }
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
  Vector12 measured_ = Vector12::Zero(), model_ = Vector12::Zero();  // [N.m] summed up
  double time_ = 0.0;                                                // [s]
};

}  // namespace surefoot
