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
class LegLift {
 public:
  static constexpr double kTime = 0.5;    ///< [s] in all: torques fade in for half of it
  static constexpr double kLook = 0.1;    ///< [s] at its end, over which torques are averaged
  static constexpr double kShare = 0.4;   ///< of what bears a leg that its spring takes back ...
  static constexpr double kMost = 1.3;    ///< ... no more: then something else pushes it
  static constexpr double kCounts = 0.3;  ///< of the greatest such torque: below it a joint is none
  static constexpr double kAlike = 0.06;  ///< that these shares may differ from one of them ...
  static constexpr double kJoints = 0.5;  ///< ... in so many of the joints, hips and others ...
  static constexpr int kFew = 3;          ///< ... and no fewer than these

  /// @param measured, model torques of all motors that bear the legs [N.m] @param dt [s]
  void update(const Vector12& measured, const Vector12& model, double dt) noexcept {
    time_ += dt;
    if (time_ <= kTime - kLook) return;
    measured_ += measured;
    model_ += model;
  }
  bool done() const noexcept { return time_ >= kTime; }
  bool too_light() const noexcept {
    const double counts = kCounts * model_.cwiseAbs().maxCoeff();
    Vector12 back = Vector12::Zero();
    int joints = 0, most = 0;
    for (int i = 0; i < kMotors; ++i) {
      if (std::abs(model_[i]) < counts) continue;
      ++joints;
      back[i] = 1.0 - measured_[i] / model_[i];
    }
    for (int i = 0; i < kMotors; ++i) {
      if (!(back[i] > kShare && back[i] < kMost)) continue;
      const Eigen::Array<bool, kMotors, 1> alike = (back.array() - back[i]).abs() < kAlike;
      int hips = 0;
      for (int leg = 0; leg < kLegs; ++leg) hips += alike[kLegJoints * leg];
      const int all = static_cast<int>(alike.count());
      if (hips > 0 && hips < all) most = std::max(most, all);
    }
    return most >= kFew && most >= kJoints * joints;
  }

 private:
  Vector12 measured_ = Vector12::Zero(), model_ = Vector12::Zero();  // [N.m] summed up
  double time_ = 0.0;                                                // [s]
};

}  // namespace surefoot
